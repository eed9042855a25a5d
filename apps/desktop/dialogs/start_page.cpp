// Where a person begins: new sheets, files, examples, the tour.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/start_page.h"

#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMap>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/dialogs/sheet_dialog.h"
#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/icons.h"
#include "apps/desktop/services/gallery.h"

namespace kiri::desktop {

namespace {

constexpr int kCardPicture = 132;
constexpr QSize kCard(164, 178);

/// A file as it is now: another time of change is another picture.
QString keyOf(const QString& path) {
  return path + QFileInfo(path).lastModified().toString(Qt::ISODateWithMs);
}

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

struct StartPage::Pictures {
  QMap<QString, ModelCard> made;
};

StartPage::StartPage(TaskRunner& runner, Settings& settings, QWidget* parent)
    : QWidget(parent),
      runner_(runner),
      settings_(settings),
      pictures_(std::make_shared<Pictures>()) {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(40, 32, 40, 32);
  column->setSpacing(28);
  column->addWidget(makeHead());
  column->addWidget(makeSheets());
  recentPart_ = makeGallery(tr("Recent"), recent_);
  column->addWidget(recentPart_);
  examplesPart_ = makeGallery(tr("Examples"), examples_);
  column->addWidget(examplesPart_);
  column->addStretch();
  auto* area = new QScrollArea;
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(area);
  connect(recent_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    emit fileChosen(item->data(Qt::UserRole).toString());
  });
  connect(examples_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    emit exampleChosen(item->data(Qt::UserRole).toString());
  });
  connect(&settings_, &Settings::recentFilesChanged, this, [this] {
    if (isVisible()) refresh();
  });
}

StartPage::~StartPage() = default;

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
  words->addStretch();
  words->addWidget(name);
  words->addWidget(remark(tr("Fold, tear and cut a sheet of paper.")));
  words->addStretch();
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
    button->setMinimumSize(112, 100);
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

QWidget* StartPage::makeGallery(const QString& title, QListWidget*& list) {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(headline(title));
  list = new QListWidget;
  list->setAccessibleName(title);
  list->setViewMode(QListView::IconMode);
  list->setIconSize({kCardPicture, kCardPicture});
  list->setGridSize(kCard);
  list->setMovement(QListView::Static);
  list->setResizeMode(QListView::Adjust);
  list->setWordWrap(true);
  list->setTextElideMode(Qt::ElideRight);
  list->setFrameShape(QFrame::NoFrame);
  list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->viewport()->setAutoFillBackground(false);
  // One click is enough, as with all buttons of the page; keys work as in any list.
  connect(list, &QListWidget::itemClicked, list, &QListWidget::itemActivated);
  column->addWidget(list);
  return part;
}

void StartPage::refresh() {
  fill(*recent_, settings_.recentFiles());
  fill(*examples_, modelsIn(examplesFolder()));
  recentPart_->setVisible(recent_->count() > 0);
  examplesPart_->setVisible(examples_->count() > 0);
  fitHeights();
}

void StartPage::fill(QListWidget& list, const QStringList& paths) {
  QStringList shown;
  for (int i = 0; i < list.count(); ++i) shown.append(list.item(i)->data(Qt::UserRole).toString());
  if (shown != paths) {
    list.clear();
    for (const QString& path : paths) {
      auto* item = new QListWidgetItem(QFileInfo(path).completeBaseName().replace('_', ' '), &list);
      item->setData(Qt::UserRole, path);
      item->setToolTip(path);
      item->setSizeHint(kCard);
      QPixmap empty(kCardPicture, kCardPicture);
      empty.fill(Qt::transparent);
      item->setIcon(QIcon(empty));
    }
  }
  for (int i = 0; i < list.count(); ++i)
    askPicture(*list.item(i), list.item(i)->data(Qt::UserRole).toString());
}

void StartPage::askPicture(QListWidgetItem& item, const QString& path) {
  const QString key = keyOf(path);
  const auto show = [](QListWidgetItem& shown, const ModelCard& card) {
    shown.setText(card.title);
    if (!card.picture.isNull()) shown.setIcon(QIcon(QPixmap::fromImage(card.picture)));
  };
  const auto found = pictures_->made.constFind(key);
  if (found != pictures_->made.constEnd()) {
    show(item, *found);
    return;
  }
  const double ratio = devicePixelRatioF();
  auto card = std::make_shared<ModelCard>();
  runner_.start({{},
                 [path, card, pixels = static_cast<int>(kCardPicture * ratio),
                  alive = std::weak_ptr<Pictures>(pictures_)](const Progress& progress) {
                   if (alive.expired()) return;
                   *card = cardOf(path, pixels, [&](double done) {
                     return !alive.expired() && goesOn(progress, done);
                   });
                 },
                 [page = QPointer<StartPage>(this), path, key, card, ratio, show] {
                   if (!page) return;
                   card->picture.setDevicePixelRatio(ratio);
                   page->pictures_->made.insert(key, *card);
                   for (QListWidget* list : {page->recent_, page->examples_}) {
                     for (int i = 0; i < list->count(); ++i) {
                       if (list->item(i)->data(Qt::UserRole).toString() == path)
                         show(*list->item(i), *card);
                     }
                   }
                 }});
}

/// The lists are as high as what they show: the page scrolls, not the lists.
void StartPage::fitHeights() {
  for (QListWidget* list : {recent_, examples_}) {
    const int columns = std::max(1, list->viewport()->width() / kCard.width());
    const int rows = (list->count() + columns - 1) / columns;
    list->setFixedHeight(std::max(1, rows) * kCard.height() + 4);
  }
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitHeights();
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
