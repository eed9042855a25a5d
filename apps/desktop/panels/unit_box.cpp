// A box for a number with a unit, which takes other units and small sums too.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/unit_box.h"

#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <cmath>
#include <numbers>

namespace kiri::desktop {
namespace {

constexpr int kDecimals = 3;

/// How much of `unit` one of the typed unit is; none where they measure different things.
std::optional<double> factorOf(const QString& typed, const QString& unit) {
  if (typed.isEmpty() || typed == unit) return 1;
  if (unit == "mm") {
    if (typed == "cm") return 10;
    if (typed == "m") return 1000;
    if (typed == "in" || typed == "inch" || typed == "\"") return 25.4;
    if (typed == "pt") return 25.4 / 72;
  }
  if (unit == "°") {
    if (typed == "deg" || typed == "d") return 1;
    if (typed == "rad") return 180 / std::numbers::pi;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> typedNumber(const QString& text, const QString& unit) {
  static const QRegularExpression form(
      R"(^\s*([-+−]?\d*[.,]?\d*)\s*(?:/\s*(\d+(?:[.,]\d+)?))?\s*([^\d\s]*)\s*$)");
  const QRegularExpressionMatch match = form.match(text);
  if (!match.hasMatch()) return std::nullopt;
  const auto number = [](QString digits) {
    bool isNumber = false;
    const double value = digits.replace(',', '.').replace("−", "-").toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
  };
  const std::optional<double> value = number(match.captured(1));
  const std::optional<double> factor = factorOf(match.captured(3), unit);
  if (!value || !factor) return std::nullopt;
  const double divisor = match.captured(2).isEmpty() ? 1 : number(match.captured(2)).value_or(0);
  if (divisor == 0) return std::nullopt;
  return *value / divisor * *factor;
}

UnitBox::UnitBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setDecimals(kDecimals);
  setLocale(QLocale::c());
  setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
  setAccelerated(true);
  setStepType(QAbstractSpinBox::DefaultStepType);
}

void UnitBox::setUnit(const QString& unit) {
  unit_ = unit;
  // "90°" but "12 mm".
  setSuffix(unit.isEmpty() || unit == "°" ? unit : " " + unit);
}

QString UnitBox::textFromValue(double value) const {
  QString text = QString::number(value, 'f', kDecimals);
  while (text.endsWith('0')) text.chop(1);
  if (text.endsWith('.')) text.chop(1);
  return text == "-0" ? "0" : text;
}

/// What is typed stands before the box's own unit: "4 cm mm".
QString UnitBox::typed(const QString& text) const {
  return text.endsWith(suffix()) ? text.chopped(suffix().size()) : text;
}

double UnitBox::valueFromText(const QString& text) const {
  return typedNumber(typed(text), unit_).value_or(value());
}

QValidator::State UnitBox::validate(QString& text, int&) const {
  const std::optional<double> number = typedNumber(typed(text), unit_);
  if (!number) return QValidator::Intermediate;  // still being typed
  return *number >= minimum() && *number <= maximum() ? QValidator::Acceptable
                                                      : QValidator::Intermediate;
}

}  // namespace kiri::desktop
