// Lobes, teeth and sinuses of a leaf's margin.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/region.h"

namespace kiri {

/// A tip or a sinus: where the margin is farthest from the petiole, or nearest to it.
struct MarginPoint {
  bool isLobe = true;
  Vec2 place;         ///< paper frame, mm
  double angle = 0;   ///< degrees from the axis, clockwise positive (right half), -180 to 180
  double length = 0;  ///< mm from the petiole
  /// Of a tip: how far its sinus reaches down its own axis to the petiole, 0 to 1. The sinus is the
  /// shallower of those that part it from tips as long or longer; of the longest tip, the shallower
  /// of those that part it from the lobes beside it.
  double reach = 0;
  /// Of a tip: it is no lobe by the rule of Royer et al. (2005), for its sinus reaches no farther
  /// than a quarter of its axis. The longest tip is no tooth, but the apex.
  bool isTooth = false;
};

/// A tooth becomes a lobe where its sinus reaches farther than this. Source: Royer, Wilf, Janesko,
/// Kowalski, Dilcher, American Journal of Botany 92 (2005).
inline constexpr double kLobeReach = 0.25;

/// What petiole and axis a margin is looked at from.
struct LeafAxis {
  Vec2 petiole;
  Vec2 direction{0, 1};  ///< unit, from the petiole to the apex
};

/// Tips and sinuses by turns, from the left side of the base clockwise to the right one. Tips that
/// stand out from the sinuses beside them by less than `prominence` mm are left out.
std::vector<MarginPoint> marginPoints(const Loop& contour, const LeafAxis& axis, double prominence);

}  // namespace kiri
