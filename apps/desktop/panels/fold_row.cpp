// One fold line: mountain or valley, name, angle, slider.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/fold_row.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QScopedValueRollback>
#include <QSlider>
#include <cmath>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/icons.h"
#include "apps/desktop/look/theme.h"
#include "apps/desktop/panels/unit_box.h"

namespace kiri::desktop {
namespace {

constexpr double kTicksOfDegree = 10;  // of the slider for a degree
constexpr double kMost = 180;
constexpr int kRest = 700;  // ms without a key after which the step is made
constexpr int kFoldSign = 18;

int ticksOf(double degrees) { return static_cast<int>(std::lround(degrees * kTicksOfDegree)); }

}  // namespace

FoldRow::FoldRow(QWidget* parent)
    : QWidget(parent),
      name_(new QLabel(this)),
      bar_(new QSlider(Qt::Horizontal, this)),
      box_(new UnitBox(this)) {
  setFixedHeight(kHeight);
  bar_->setRange(0, ticksOf(kMost));
  bar_->setSingleStep(ticksOf(1));
  bar_->setPageStep(ticksOf(15));
  box_->setUnit("°");
  box_->setRange(-kMost, kMost);
  box_->setDecimals(1);
  box_->setKeyboardTracking(false);
  box_->setFixedWidth(84);
  name_->setTextInteractionFlags(Qt::NoTextInteraction);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 4, 12, 6);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(1);
  grid->setColumnMinimumWidth(0, kFoldSign);
  grid->addWidget(name_, 0, 1);
  grid->addWidget(box_, 0, 2, 2, 1, Qt::AlignVCenter);
  grid->addWidget(bar_, 1, 1);
  grid->setColumnStretch(1, 1);
  rest_.setSingleShot(true);
  rest_.setInterval(kRest);
  connect(&rest_, &QTimer::timeout, this, &FoldRow::release);
  connect(bar_, &QSlider::sliderPressed, this, &FoldRow::hold);
  connect(bar_, &QSlider::sliderReleased, this, &FoldRow::release);
  connect(bar_, &QSlider::valueChanged, this, [this](int ticks) {
    if (isUpdating_) return;
    if (!bar_->isSliderDown()) {
      hold();
      rest_.start();
    }
    emit moved(ticks / kTicksOfDegree);
  });
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
    if (!isUpdating_) set(degrees);
  });
}

void FoldRow::hold() {
  if (isHeld_ || !shown_) return;
  isHeld_ = true;
  emit held(shown_->line);
}

void FoldRow::release() {
  rest_.stop();
  if (!isHeld_) return;
  isHeld_ = false;
  emit released(true);
}

void FoldRow::set(double degrees) {
  hold();
  emit moved(degrees);
  release();
}

void FoldRow::show(const FoldSlider& slider) {
  const QScopedValueRollback<bool> updating(isUpdating_, true);
  shown_ = slider;
  const QString name = toQt(slider.name);
  name_->setText(name_->fontMetrics().elidedText(name, Qt::ElideRight, 150));
  name_->setToolTip(name);
  bar_->setAccessibleName(tr("Angle of %1").arg(name));
  box_->setAccessibleName(bar_->accessibleName());
  setEnabled(slider.canMove);
  bar_->setToolTip(slider.canMove ? QString() : tr("This fold line has no hinges left"));
  if (!isHeld_) {
    bar_->setValue(ticksOf(slider.amount.value_or(0)));
    box_->setValue(slider.amount.value_or(0));
    box_->setSpecialValueText({});
  }
  update();
}

void FoldRow::showAmount(double degrees) {
  const QScopedValueRollback<bool> updating(isUpdating_, true);
  box_->setValue(degrees);
}

void FoldRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!shown_) return;
  const QString sign = shown_->isValley ? "valley" : "mountain";
  icon(sign).paint(&painter, QRect(10, 8, kFoldSign, kFoldSign), Qt::AlignCenter,
                   isEnabled() ? QIcon::Normal : QIcon::Disabled);
  painter.setPen(theme().line);
  painter.drawLine(12, height() - 1, width() - 12, height() - 1);
}

}  // namespace kiri::desktop
