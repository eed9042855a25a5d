// The bar above the panes: which tool is at work, its numbers and choices, do it or drop it.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/field_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

namespace kiri::desktop {
namespace {

constexpr int kHeight = 44;
constexpr int kIcon = 20;

QToolButton* buttonFor(QAction& action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(&action);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setIconSize({kIcon, kIcon});
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

FieldBar::FieldBar(SessionHub& hub, QAction& commit, QAction& cancel, QWidget* parent)
    : QFrame(parent),
      hub_(hub),
      picture_(new QLabel(this)),
      name_(new QLabel(this)),
      room_(new QScrollArea(this)),
      editor_(new FieldEditor(FieldEditor::Layout::Row, this)),
      more_(new QToolButton(this)),
      rest_(new FieldEditor(FieldEditor::Layout::Form, this)),
      commit_(buttonFor(commit, this)),
      cancel_(buttonFor(cancel, this)) {
  setObjectName("fieldBar");
  setFixedHeight(kHeight);
  room_->setWidget(editor_);
  room_->setWidgetResizable(true);
  room_->setFrameShape(QFrame::NoFrame);
  room_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  room_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  room_->setFocusPolicy(Qt::NoFocus);
  more_->setText(tr("More"));
  more_->setToolTip(tr("The fields that have no room here"));
  more_->setProperty("segment", true);
  more_->setFocusPolicy(Qt::TabFocus);
  rest_->setWindowFlags(Qt::Popup);
  rest_->setContentsMargins(14, 12, 14, 12);
  rest_->hide();
  auto* line = new QHBoxLayout(this);
  commit_->setObjectName("commit");
  commit_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  line->setContentsMargins(12, 4, 8, 4);
  line->setSpacing(8);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  name_->setFont(bold);
  line->addWidget(picture_);
  line->addWidget(name_);
  line->addSpacing(10);
  line->addWidget(room_, 1);
  line->addWidget(more_);
  line->addWidget(cancel_);
  line->addWidget(commit_);
  connect(editor_, &FieldEditor::edited, this, &FieldBar::tell);
  connect(rest_, &FieldEditor::edited, this, &FieldBar::tell);
  connect(more_, &QToolButton::clicked, this, &FieldBar::showMore);
  connect(&hub, &SessionHub::marksChanged, this, &FieldBar::refresh);
  connect(&hub, &SessionHub::shownChanged, this, &FieldBar::refresh);
  connect(&hub, &SessionHub::toolChanged, this, &FieldBar::refresh);
  refresh();
}

void FieldBar::setTool(const QAction& tool) {
  picture_->setPixmap(tool.icon().pixmap(QSize(kIcon, kIcon), devicePixelRatioF()));
  name_->setText(tool.iconText());
}

void FieldBar::tell(const QString& id, const FieldValue& value) {
  hub_.session().setField(id.toStdString(), value);
}

void FieldBar::refresh() {
  editor_->show(hub_.session().fields());
  const bool canCommit = hub_.session().canCommit();
  commit_->setVisible(canCommit);
  cancel_->setVisible(canCommit);
  fit();
}

/// A narrow window keeps the first fields; the others are a click away.
void FieldBar::fit() {
  const std::vector<Field>& fields = editor_->fields();
  const int width = room_->width() + (more_->isVisible() ? more_->width() : 0);
  std::size_t shown = editor_->fitInto(width);
  if (shown < fields.size()) shown = editor_->fitInto(width - more_->sizeHint().width() - 8);
  more_->setVisible(shown < fields.size());
  rest_->show({fields.begin() + static_cast<std::ptrdiff_t>(shown), fields.end()});
  if (shown == fields.size()) rest_->hide();
}

void FieldBar::showMore() {
  rest_->adjustSize();
  const QPoint corner = more_->mapToGlobal(QPoint(more_->width(), more_->height() + 4));
  rest_->move(corner - QPoint(rest_->width(), 0));
  rest_->setVisible(true);
  rest_->setFocus();
}

void FieldBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit();
}

}  // namespace kiri::desktop
