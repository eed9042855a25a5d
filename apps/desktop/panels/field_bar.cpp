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
      editor_(new FieldEditor(FieldEditor::Layout::Row, this)),
      commit_(buttonFor(commit, this)),
      cancel_(buttonFor(cancel, this)) {
  setObjectName("fieldBar");
  setFixedHeight(kHeight);
  // A narrow window scrolls the fields; the buttons stay in reach.
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(editor_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(12, 4, 8, 4);
  line->setSpacing(8);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  name_->setFont(bold);
  line->addWidget(picture_);
  line->addWidget(name_);
  line->addSpacing(10);
  line->addWidget(scroll, 1);
  line->addWidget(cancel_);
  line->addWidget(commit_);
  connect(editor_, &FieldEditor::edited, this, [this](const QString& id, const FieldValue& value) {
    hub_.session().setField(id.toStdString(), value);
  });
  connect(&hub, &SessionHub::marksChanged, this, &FieldBar::refresh);
  connect(&hub, &SessionHub::shownChanged, this, &FieldBar::refresh);
  connect(&hub, &SessionHub::toolChanged, this, &FieldBar::refresh);
  refresh();
}

void FieldBar::setTool(const QAction& tool) {
  picture_->setPixmap(tool.icon().pixmap(QSize(kIcon, kIcon), devicePixelRatioF()));
  name_->setText(tool.iconText());
}

void FieldBar::refresh() {
  editor_->show(hub_.session().fields());
  const bool canCommit = hub_.session().canCommit();
  commit_->setVisible(canCommit);
  cancel_->setVisible(canCommit);
}

}  // namespace kiri::desktop
