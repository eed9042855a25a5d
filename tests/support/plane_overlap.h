// Overlap of polygons in a plane by slabs: slow, short, and independent of the kernel's clipping.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/geometry/rigid.h"
#include "core/paper/crease_pattern.h"

namespace kiri::test {

/// Loops of a polygon with holes, in any direction; inside is decided by counting crossings
/// (even-odd).
using Loops = std::vector<std::vector<Vec2>>;

/// Border of a facet in the paper frame; each curved edge becomes `pieces` chords, the same ones
/// for both of its facets.
Loops flatLoopsOf(const CreasePattern& pattern, FacetId facet, int pieces = 8);

/// Two axes and an origin in a plane of the model frame.
struct PlaneFrame {
  Vec3 origin;
  Vec3 u;
  Vec3 v;
  Vec2 flatten(Vec3 p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
};
PlaneFrame frameOf(Vec3 normal, Vec3 origin);

/// Loops moved by a pose into a plane.
Loops placed(const Loops& loops, const Rigid& pose, const PlaneFrame& frame);

double areaOf(const Loops& loops);
bool contains(const Loops& loops, Vec2 point);

/// What several polygons have in common.
struct Common {
  double area = 0;
  Vec2 low;
  Vec2 high;
  /// Lower bound of area / perimeter for shapes without holes and bays, 0 when there is nothing.
  double fatness() const;
};
Common commonOf(const std::vector<const Loops*>& polygons);

}  // namespace kiri::test
