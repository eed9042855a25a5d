// Regions of a plane bounded by lines and exact curves.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/cubic.h"
#include "core/geometry/tolerance.h"

namespace kiri {

/// A closed chain of arcs: each ends where the next starts, the last where the first starts.
using Loop = std::vector<Arc>;

/// A connected piece of a plane: loops[0] is the outer border, counter-clockwise; the others are
/// holes, clockwise. A loop may run along the same arc twice, forth and back (a slit).
struct Region {
  std::vector<Loop> loops;
};

/// Area in mm^2, exact for curves up to rounding.
double areaOf(const Region& region);
double signedAreaOf(const Loop& loop);
double perimeterOf(const Region& region, double tolerance);
Box boundsOf(const Region& region);

enum class Where { Inside, OnBorder, Outside };
/// Where `p` lies; on the border means within `distance` of it. Curves are taken exactly, not as
/// polylines.
Where locate(const Region& region, Vec2 p, double distance);

/// A point well inside (far from the border as such points go; deterministic). Requires an area
/// above zero.
Vec2 interiorPoint(const Region& region, const Tolerance& tolerance);

/// A convex polygon, counter-clockwise. `tags[i]` tells where the side from point i to point i + 1
/// comes from: the number of the arc in the region (counting through all loops), or kInner for a
/// side that only divides the region.
struct ConvexPart {
  static constexpr std::int32_t kInner = -1;
  std::vector<Vec2> points;
  std::vector<std::int32_t> tags;
};

/// The region as convex parts that do not overlap and cover it, curves flattened to
/// `tolerance.flattening()`. A convex straight region is returned as it is, in one part. Parts
/// share whole sides or parts of sides.
std::vector<ConvexPart> convexParts(const Region& region, const Tolerance& tolerance);

/// True when the region is one convex loop of straight arcs (collinear vertices allowed).
bool isConvexPolygon(const Region& region, const Tolerance& tolerance);

}  // namespace kiri
