// The sliders of the fold lines, and the one for all of them.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/folds_panel.h"

#include <QButtonGroup>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/panels/fold_rows.h"

namespace kiri::desktop {
namespace {

constexpr int kTicks = 1000;  // of the slider for all

QToolButton* segment(const QString& text, const QString& help, QButtonGroup& group,
                     QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setToolTip(help);
  button->setCheckable(true);
  button->setProperty("segment", true);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  group.addButton(button);
  return button;
}

}  // namespace

FoldsPanel::FoldsPanel(SessionHub& hub, QWidget* parent)
    : QWidget(parent),
      hub_(hub),
      all_(new QSlider(Qt::Horizontal, this)),
      said_(new QLabel(this)),
      empty_(new QLabel(tr("Each fold line gets a slider here."), this)),
      rows_(new FoldRows(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeHead());
  column->addWidget(empty_);
  column->addWidget(rows_, 1);
  column->addWidget(said_);
  column->addStretch(0);
  said_->setWordWrap(true);
  said_->setContentsMargins(12, 6, 12, 8);
  empty_->setContentsMargins(12, 8, 12, 8);
  empty_->setWordWrap(true);
  empty_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  empty_->setProperty("faint", true);
  connect(rows_, &FoldRows::held, this,
          [this](FoldLineId line) { hub_.session().beginSlide(line); });
  connect(rows_, &FoldRows::moved, this, [this](double degrees) { hub_.session().slide(degrees); });
  connect(rows_, &FoldRows::released, this, [this](bool keep) { hub_.session().endSlide(keep); });
  connect(&hub, &SessionHub::documentChanged, this, &FoldsPanel::refresh);
  connect(&hub, &SessionHub::shownChanged, this, &FoldsPanel::showSlide);
  connect(&hub, &SessionHub::marksChanged, this, &FoldsPanel::showSlide);
  refresh();
  showSlide();
}

QWidget* FoldsPanel::makeHead() {
  auto* head = new QWidget(this);
  head->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* column = new QVBoxLayout(head);
  column->setContentsMargins(12, 10, 12, 8);
  column->setSpacing(8);
  auto* line = new QHBoxLayout;
  line->setSpacing(0);
  auto* group = new QButtonGroup(head);
  together_ = segment(tr("Together"), tr("All folds open at once, as leaves do"), *group, head);
  inOrder_ = segment(tr("In order"), tr("Folds open one after the other, the last one first"),
                     *group, head);
  line->addWidget(together_);
  line->addWidget(inOrder_);
  column->addLayout(line);
  auto* sliding = new QHBoxLayout;
  auto* folded = new QLabel(tr("Folded"), head);
  auto* open = new QLabel(tr("Open"), head);
  for (QLabel* label : {folded, open}) label->setProperty("faint", true);
  all_->setRange(0, kTicks);
  all_->setAccessibleName(tr("All folds"));
  all_->setToolTip(tr("Opens all folds"));
  sliding->addWidget(folded);
  sliding->addWidget(all_, 1);
  sliding->addWidget(open);
  column->addLayout(sliding);
  connect(together_, &QToolButton::clicked, this, [this] { setLeaf(true); });
  connect(inOrder_, &QToolButton::clicked, this, [this] { setLeaf(false); });
  connect(all_, &QSlider::sliderPressed, this, [this] { hub_.session().beginSlideAll(); });
  connect(all_, &QSlider::sliderReleased, this, [this] { hub_.session().endSlideAll(true); });
  connect(all_, &QSlider::valueChanged, this, [this](int ticks) {
    if (isUpdating_) return;
    const bool isDragged = all_->isSliderDown();
    if (!isDragged) hub_.session().beginSlideAll();
    hub_.session().slideAll(static_cast<double>(ticks) / kTicks);
    if (!isDragged) hub_.session().endSlideAll(true);
  });
  return head;
}

void FoldsPanel::setLeaf(bool isLeaf) { hub_.session().setLeaf(isLeaf); }

void FoldsPanel::refresh() {
  const QScopedValueRollback<bool> updating(isUpdating_, true);
  const std::vector<FoldSlider> sliders = hub_.session().sliders();
  empty_->setVisible(sliders.empty());
  rows_->setVisible(!sliders.empty());
  all_->setEnabled(!sliders.empty());
  (hub_.session().isLeaf() ? together_ : inOrder_)->setChecked(true);
  if (!all_->isSliderDown())
    all_->setValue(static_cast<int>(std::lround(hub_.session().openness() * kTicks)));
  rows_->show(sliders);
}

void FoldsPanel::showSlide() {
  if (const std::optional<SlideShow>& show = hub_.session().slideShow()) {
    rows_->showAmount(show->amount);
    if (show->stop) {
      say(toQt(show->stop->message), true);
    } else if (!show->collisions.empty()) {
      say(toQt(show->collisions.front().message), false);
    } else {
      say({}, false);
    }
    return;
  }
  const std::optional<Error>& problem = hub_.session().slideProblem();
  say(problem ? toQt(problem->message) : QString(), true);
}

void FoldsPanel::say(const QString& text, bool isFault) {
  if (said_->text() == text) return;
  said_->setText(text);
  said_->setVisible(!text.isEmpty());
  said_->setProperty("fault", isFault);
  said_->setProperty("warning", !isFault);
  said_->style()->polish(said_);
}

}  // namespace kiri::desktop
