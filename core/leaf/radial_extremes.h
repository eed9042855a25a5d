// Where a contour comes nearest to a point and goes farthest from it, over and over.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/region.h"

namespace kiri {

struct RadialExtreme {
  bool isFarthest = true;
  Vec2 place;
  double radius = 0;
};

/// The local extremes of the distance from `centre` along a closed contour, farthest and nearest by
/// turns, in the order of the contour. Pairs that differ by less than `prominence` are left out,
/// the least first; where no two differ by more, there are none.
std::vector<RadialExtreme> radialExtremes(const Loop& contour, Vec2 centre, double prominence);

}  // namespace kiri
