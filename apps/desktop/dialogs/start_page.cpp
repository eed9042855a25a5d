// Where a person begins: new sheets, files, examples, the tour.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/start_page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include "apps/desktop/dialogs/card_delegate.h"
#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/dialogs/sheet_dialog.h"
#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/icons.h"

namespace kiri::desktop {

namespace {

constexpr int kRoomForPreview = 840;  // of the page's width; narrower ones show cards only
constexpr int kPageMargin = 32;

QPushButton* bigButton(const QString& iconName, const QString& text, bool isFirst) {
  auto* button = new QPushButton(icon(iconName), text);
  button->setIconSize({24, 24});
  button->setMinimumHeight(44);
  button->setMinimumWidth(button->sizeHint().width() + 24);
  button->setDefault(isFirst);
  button->setAutoDefault(true);
  return button;
}

}  // namespace

StartPage::StartPage(TaskRunner& runner, Settings& settings, QWidget* parent)
    : QWidget(parent),
      settings_(settings),
      cards_(new ModelCards(runner, this)),
      area_(new QScrollArea),
      gallery_(new GalleryPart(*cards_)),
      preview_(new ModelPreview(*cards_, runner)) {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(kPageMargin, 28, kPageMargin, 28);
  column->setSpacing(24);
  column->addWidget(makeHead());
  column->addWidget(makeSheets());
  column->addWidget(makeRecent());
  column->addWidget(gallery_);
  column->addStretch();
  area_->setWidget(page);
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(area_, 1);
  layout->addWidget(preview_);
  connectParts();
}

StartPage::~StartPage() = default;

void StartPage::connectParts() {
  connect(recent_, &CardList::looked, preview_, &ModelPreview::show);
  connect(gallery_, &GalleryPart::looked, preview_, &ModelPreview::show);
  connect(recent_, &CardList::chosen, this, &StartPage::fileChosen);
  connect(gallery_, &GalleryPart::chosen, this, &StartPage::exampleChosen);
  connect(preview_, &ModelPreview::chosen, this, &StartPage::open);
  // The page scrolls so that what the keyboard has reached is seen.
  const auto reach = [this](QWidget* list, const QRect& card) {
    const QPoint middle = list->mapTo(area_->widget(), card.center());
    area_->ensureVisible(middle.x(), middle.y(), 0, card.height());
  };
  connect(gallery_, &GalleryPart::reached, this, reach);
  connect(recent_, &CardList::reached, this,
          [this, reach](const QRect& card) { reach(recent_, card); });
  connect(recent_, &CardList::left, this, [this](int direction, int) {
    if (direction > 0) gallery_->search().setFocus(Qt::TabFocusReason);
  });
  auto* find = new QShortcut(QKeySequence::Find, this);
  find->setContext(Qt::WidgetWithChildrenShortcut);
  connect(find, &QShortcut::activated, this, [this] {
    gallery_->search().setFocus(Qt::ShortcutFocusReason);
    gallery_->search().selectAll();
    area_->ensureWidgetVisible(&gallery_->search());
  });
  connect(&settings_, &Settings::recentFilesChanged, this, [this] {
    if (isVisible()) refresh();
  });
}

void StartPage::open(const QString& path) {
  if (gallery_->paths().contains(path)) return emit exampleChosen(path);
  emit fileChosen(path);
}

QWidget* StartPage::makeHead() {
  constexpr int kIcon = 72;
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(20);
  auto* picture = new QLabel;
  picture->setPixmap(icon("kirisim").pixmap(QSize(kIcon, kIcon), devicePixelRatioF()));
  auto* words = new QVBoxLayout;
  auto* name = headline(QStringLiteral("KiriSim"));
  QFont font = name->font();
  font.setPointSizeF(font.pointSizeF() * 1.5);
  name->setFont(font);
  words->setSpacing(4);
  words->addStretch(1);
  words->addWidget(name);
  words->addWidget(remark(tr("Fold, tear and cut a sheet of paper.")));
  words->addStretch(1);
  QPushButton* tour = bigButton("tour", tr("Fold your first leaf"), true);
  tour->setToolTip(tr("Five steps, each waits for your hand"));
  QPushButton* open = bigButton("open", tr("Open…"), false);
  row->addWidget(picture);
  row->addLayout(words, 1);
  row->addWidget(open);
  row->addWidget(tour);
  connect(tour, &QPushButton::clicked, this, &StartPage::tourWanted);
  connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
  return head;
}

QWidget* StartPage::makeSheets() {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(headline(tr("New sheet")));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  const auto add = [&](const QString& iconName, const QString& text) {
    auto* button = new QToolButton;
    button->setIcon(icon(iconName));
    button->setIconSize({40, 40});
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setMinimumSize(100, 100);
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    row->addWidget(button);
    return button;
  };
  for (const SheetPreset& preset : sheetPresets()) {
    connect(add(iconOf(preset), said(preset.name) + "\n" + said(preset.size)),
            &QToolButton::clicked, this, [this, model = preset.model] { emit modelChosen(model); });
  }
  connect(add("new", tr("Other…")), &QToolButton::clicked, this, &StartPage::otherSheetWanted);
  row->addStretch();
  column->addLayout(row);
  return part;
}

QWidget* StartPage::makeRecent() {
  recentPart_ = new QWidget;
  auto* column = new QVBoxLayout(recentPart_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(headline(tr("Recent")));
  recent_ = new CardList(*cards_, tr("Recent"));
  column->addWidget(recent_);
  return recentPart_;
}

void StartPage::refresh() {
  const QStringList recent = settings_.recentFiles();
  recent_->show(recent);
  recentPart_->setVisible(!recent.isEmpty());
  gallery_->show(exampleGroups());
  const QStringList examples = gallery_->paths();
  gallery_->setVisible(!examples.isEmpty());
  fit();
  cards_->want(recent + examples, static_cast<int>(CardDelegate::kPicture * devicePixelRatioF()));
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

/// Notes are beside the cards where there is room, else beside the pointer.
void StartPage::fit() {
  const bool hasPreview = width() >= kRoomForPreview;
  preview_->setVisible(hasPreview);
  recent_->setTips(!hasPreview);
  for (CardList* list : gallery_->lists()) list->setTips(!hasPreview);
}

void StartPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    emit closeWanted();
  } else {
    QWidget::keyPressEvent(event);
  }
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

}  // namespace kiri::desktop
