// SPDX-License-Identifier: MIT
#include "core/base/text.h"

#include <cmath>
#include <cstdio>

namespace kiri {

std::string text(double number) {
  char buffer[32];
  // Adding zero turns a negative zero into a plain one.
  std::snprintf(buffer, sizeof buffer, "%.6g", number + 0.0);
  return buffer;
}

std::string text(Vec2 point) {
  // Beside the other coordinate, so little is rounding.
  constexpr double kTrifle = 1.0 / (1 << 30);
  const double x = std::abs(point.x) <= kTrifle * std::abs(point.y) ? 0 : point.x;
  const double y = std::abs(point.y) <= kTrifle * std::abs(point.x) ? 0 : point.y;
  return "(" + text(x) + ", " + text(y) + ")";
}

}  // namespace kiri
