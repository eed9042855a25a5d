// SPDX-License-Identifier: MIT
#include "core/geometry/arc_range.h"

#include <algorithm>
#include <cmath>

namespace kiri {

Range rangeAlong(const Arc& arc, Vec2 direction) {
  const double p0 = dot(direction, arc.start);
  const double p3 = dot(direction, arc.end);
  Range range{std::min(p0, p3), std::max(p0, p3)};
  if (!arc.isCurved) return range;
  const double p1 = dot(direction, arc.control1);
  const double p2 = dot(direction, arc.control2);
  if (std::min(p1, p2) >= range.low && std::max(p1, p2) <= range.high) return range;
  // The derivative over 3 is a t^2 + 2 b t + c; roots by the form that does not cancel.
  const double a = p3 - 3 * p2 + 3 * p1 - p0;
  const double b = p2 - 2 * p1 + p0;
  const double c = p1 - p0;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return range;
  const double q = -(b + (b < 0 ? -1 : 1) * std::sqrt(discriminant));
  for (const double t : {a != 0 ? q / a : -1, q != 0 ? c / q : -1}) {
    if (!(t > 0 && t < 1)) continue;
    const double value = dot(direction, pointAt(arc, t));
    range = {std::min(range.low, value), std::max(range.high, value)};
  }
  return range;
}

}  // namespace kiri
