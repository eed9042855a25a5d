// A box for a number with a unit, which takes other units and small sums too.
// SPDX-License-Identifier: MIT
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace kiri::desktop {

/// A number of mm, degrees or things. What is typed may carry a unit of its own ("2.5 cm", "1 in",
/// "90 deg") and a comma or a point; it is shown in the box's unit with no more digits than it has.
class UnitBox final : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit UnitBox(QWidget* parent = nullptr);
  /// "mm", "°" or nothing.
  void setUnit(const QString& unit);
  QString unit() const { return unit_; }

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

 private:
  QString typed(const QString& text) const;

  QString unit_;
};

/// What a person typed, in `unit`: a number, and perhaps another unit of the same kind. None where
/// it is no number, or of another kind.
std::optional<double> typedNumber(const QString& text, const QString& unit);

}  // namespace kiri::desktop
