// Segments of creases and margins against each other.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/orientation.h"

namespace kiri {

/// Whether the segments ab and cd cross in a point inside both; decided exactly.
inline bool doSegmentsCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

}  // namespace kiri
