// SPDX-License-Identifier: MIT
#include "core/base/text.h"

#include <cstdio>

namespace kiri {

std::string text(double number) {
  char buffer[32];
  // Adding zero turns a negative zero into a plain one.
  std::snprintf(buffer, sizeof buffer, "%.6g", number + 0.0);
  return buffer;
}

std::string text(Vec2 point) { return "(" + text(point.x) + ", " + text(point.y) + ")"; }

}  // namespace kiri
