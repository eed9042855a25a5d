// Ear clipping of polygons that may touch themselves, and joining the triangles to convex parts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/region.h"

namespace kiri {

/// A corner of a closed polygon with what is known of the side that leaves it.
struct Corner {
  static constexpr std::int32_t kNoBridge = -1;
  Vec2 point;
  std::int32_t tag = ConvexPart::kInner;  ///< as in ConvexPart
  std::int32_t bridge = kNoBridge;        ///< number of the bridge that this side runs along
};
using Ring = std::vector<Corner>;

/// Takes away sides without length, and sides that run forth and straight back along the same
/// points (slits).
Ring withoutSpikes(const Ring& ring);

/// One ring out of a border and holes, joined by bridges that run forth and back. Bridges are
/// numbered from 0.
Ring bridged(Ring border, std::vector<Ring> holes);

/// What is known of a ring beforehand.
enum class Trust {
  Simple,    ///< it may touch itself, but does not cross itself
  MayCross,  ///< polylines of curves that run close together may cross
};

/// Convex polygons that cover the counter-clockwise ring. Where it crosses itself they cover nearly
/// what it winds around once: the area is off by no more than little loops have, if `trust` says
/// so; and by anything if it does not. Cost: O(n^2), three times as much for rings that may cross
/// themselves.
std::vector<ConvexPart> convexPartsOf(const Ring& ring, Trust trust);

}  // namespace kiri
