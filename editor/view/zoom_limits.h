// How far one can zoom, and how much room a fitted picture leaves.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "core/base/vec.h"

namespace kiri {

inline double shorterSide(Vec2 pixels) { return std::max(1.0, std::min(pixels.x, pixels.y)); }

/// Part of the pane that a fitted picture fills.
inline constexpr double kFittedPart = 0.92;

/// The scale, pixels a mm, nearest to the wished one at which a thing of `radius` mm is neither
/// lost as a speck nor so large that nothing tells where one is. A scale beyond the limits may
/// stay.
inline double limitedScale(double wished, double now, double radius, Vec2 size) {
  constexpr double kSmallest = 0.02;
  constexpr double kLargest = 2000;
  const double least = kSmallest * shorterSide(size) / radius;
  const double most = kLargest * shorterSide(size) / radius;
  return std::clamp(wished, std::min(least, now), std::max(most, now));
}

}  // namespace kiri
