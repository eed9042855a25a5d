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

/// Convex polygons that cover the ring. Requires a counter-clockwise ring that does not cross
/// itself (it may touch itself); where it does cross itself the signed area is kept as well as it
/// can be.
std::vector<ConvexPart> convexPartsOf(const Ring& ring);

}  // namespace kiri
