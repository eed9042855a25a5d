// Choosing a sheet of paper.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/sheet_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/scene_painter.h"
#include "core/geometry/region.h"

namespace kiri::desktop {

namespace {

constexpr int kPicture = 240;

Box boxOfPolygon(const SheetSpec& sheet) {
  Box box{sheet.outline.front(), sheet.outline.front()};
  for (const Vec2 p : sheet.outline) box = joined(box, Box{p, p});
  return box;
}

/// The polygon stretched to a size.
SheetSpec stretched(SheetSpec sheet, double width, double height) {
  const Box box = boxOfPolygon(sheet);
  const double x = width / (box.high.x - box.low.x);
  const double y = height / (box.high.y - box.low.y);
  const auto place = [&](Vec2& p) { p = {(p.x - box.low.x) * x, (p.y - box.low.y) * y}; };
  for (Vec2& p : sheet.outline) place(p);
  for (std::vector<Vec2>& hole : sheet.holes) {
    for (Vec2& p : hole) place(p);
  }
  return sheet;
}

}  // namespace

QString iconOf(const SheetPreset& preset) {
  if (preset.id == "leaf") return "leaf";
  if (preset.id == "disc") return "disc";
  if (preset.id == "square") return "sheet";
  return "page";
}

SheetDialog::SheetDialog(const SheetSpec& start, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Sheet"));
  form_ = formLayout();
  preset_ = new QComboBox;
  preset_->addItem(tr("Own size"));
  for (const SheetPreset& preset : presets_)
    preset_->addItem(said(preset.name) + ", " + said(preset.size));
  shape_ = choiceBox({{tr("Square"), static_cast<int>(SheetSpec::Shape::Square)},
                      {tr("Rectangle"), static_cast<int>(SheetSpec::Shape::Rectangle)},
                      {tr("Disc"), static_cast<int>(SheetSpec::Shape::Disc)},
                      {tr("Polygon"), static_cast<int>(SheetSpec::Shape::Polygon)}},
                     0);
  width_ = numberBox(150, kSmallestSheet, kLargestSheet, tr(" mm"), 2);
  height_ = numberBox(150, kSmallestSheet, kLargestSheet, tr(" mm"), 2);
  form_->addRow(tr("&Paper"), preset_);
  form_->addRow(tr("&Shape"), shape_);
  form_->addRow(tr("&Width"), width_);
  form_->addRow(tr("&Height"), height_);
  picture_ = new QLabel;
  picture_->setFixedSize(kPicture, kPicture);
  picture_->setAccessibleName(tr("The sheet"));
  fault_ = remark({});

  auto* upper = new QHBoxLayout;
  upper->setSpacing(24);
  auto* left = new QVBoxLayout;
  left->addLayout(form_);
  left->addWidget(fault_);
  left->addStretch();
  upper->addLayout(left, 1);
  upper->addWidget(picture_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  take_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(12);
  layout->addLayout(upper, 1);
  withoutIcons(*buttons);
  layout->addWidget(buttons);

  connect(preset_, &QComboBox::activated, this, &SheetDialog::usePreset);
  const auto changed = [this] {
    if (isSetting_) return;
    preset_->setCurrentIndex(0);
    showRows();
    showPicture();
  };
  connect(shape_, &QComboBox::currentIndexChanged, this, changed);
  connect(width_, &QDoubleSpinBox::valueChanged, this, changed);
  connect(height_, &QDoubleSpinBox::valueChanged, this, changed);
  for (const SheetPreset& preset : presets_) {
    if (preset.model.sheet.shape == SheetSpec::Shape::Polygon) polygon_ = preset.model.sheet;
  }
  paper_ = presets_.front().model;
  setSheet(start);
}

void SheetDialog::setSheet(const SheetSpec& sheet) {
  isSetting_ = true;
  choose(*shape_, static_cast<int>(sheet.shape));
  width_->setValue(sheet.width);
  height_->setValue(sheet.height);
  if (sheet.shape == SheetSpec::Shape::Polygon && sheet.outline.size() > 2) {
    polygon_ = sheet;
    const Box box = boxOfPolygon(sheet);
    width_->setValue(box.high.x - box.low.x);
    height_->setValue(box.high.y - box.low.y);
  }
  isSetting_ = false;
  showRows();
  showPicture();
}

SheetSpec SheetDialog::sheet() const {
  SheetSpec sheet;
  sheet.shape = static_cast<SheetSpec::Shape>(chosenIn(*shape_));
  sheet.width = width_->value();
  sheet.height = sheet.shape == SheetSpec::Shape::Rectangle ? height_->value() : width_->value();
  if (sheet.shape != SheetSpec::Shape::Polygon) return sheet;
  return stretched(polygon_, width_->value(), height_->value());
}

Model SheetDialog::model() const {
  Model model = paper_;
  model.sheet = sheet();
  return model;
}

void SheetDialog::usePreset() {
  const int index = preset_->currentIndex() - 1;
  if (index < 0) return;
  paper_ = presets_[static_cast<std::size_t>(index)].model;
  setSheet(paper_.sheet);
  preset_->setCurrentIndex(index + 1);
}

void SheetDialog::showRows() {
  const auto shape = static_cast<SheetSpec::Shape>(chosenIn(*shape_));
  const bool hasHeight = shape == SheetSpec::Shape::Rectangle || shape == SheetSpec::Shape::Polygon;
  setRowVisible(*form_, *height_, hasHeight);
  auto* label = qobject_cast<QLabel*>(form_->labelForField(width_));
  label->setText(shape == SheetSpec::Shape::Disc ? tr("&Diameter") : tr("&Width"));
}

void SheetDialog::showPicture() {
  const Result<Sheet> made = makeSheet(sheet());
  take_->setEnabled(made.isOk());
  fault_->setText(made.isOk() ? QString() : sentenceOf(made.error().message));
  QPixmap pixmap(QSize(kPicture, kPicture) * devicePixelRatioF());
  pixmap.setDevicePixelRatio(devicePixelRatioF());
  pixmap.fill(Qt::transparent);
  if (made.isOk()) {
    const Box box = boundsOf(made->outline);
    const Vec2 size = box.high - box.low;
    constexpr double kMargin = 12;
    const double scale = (kPicture - 2 * kMargin) / std::max(size.x, size.y);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(kPicture / 2.0, kPicture / 2.0);
    painter.scale(scale, -scale);
    painter.translate(-(box.low.x + box.high.x) / 2, -(box.low.y + box.high.y) / 2);
    painter.setPen(QPen(QColor(30, 30, 30), 1 / scale));
    painter.setBrush(
        QColor(paper_.front.color.red, paper_.front.color.green, paper_.front.color.blue));
    painter.drawPath(pathOf(made->outline.loops));
  }
  picture_->setPixmap(pixmap);
}

}  // namespace kiri::desktop
