// A line in the plane of the folded leaf: those places whose product with a vector is 1.
// SPDX-License-Identifier: MIT
#include "core/leaf/straight_margin.h"

#include <algorithm>

#include "core/geometry/tolerance.h"

namespace kiri {

std::vector<double> straightLengths(const FoldedHalf& half) {
  double xx = 0;
  double xy = 0;
  double yy = 0;
  Vec2 sum{0, 0};
  for (std::size_t i = 0; i < half.creases().size(); ++i) {
    if (half.creases()[i].kind == RayKind::BasalEdge) continue;
    const Vec2 end = half.foldedEnd(i);
    xx += end.x * end.x;
    xy += end.x * end.y;
    yy += end.y * end.y;
    sum = sum + end;
  }
  std::vector<double> lengths(half.creases().size(), 0);
  const double determinant = xx * yy - xy * xy;
  if (determinant <= kVanishing) return lengths;
  const Vec2 line = Vec2{sum.x * yy - sum.y * xy, sum.y * xx - sum.x * xy} / determinant;
  for (std::size_t i = 0; i < half.creases().size(); ++i) {
    const LeafCrease& crease = half.creases()[i];
    const Rigid& pose = half.pose(std::min(i, half.creases().size() - 2));
    const Vec2 way = normalized(crease.end - crease.from);
    const double rise = dot(line, flatten(pose.direction(way)));
    const double missing = 1 - dot(line, flatten(pose.apply(crease.from)));
    if (rise > kVanishing && missing > 0) lengths[i] = length(crease.from + way * (missing / rise));
  }
  return lengths;
}

}  // namespace kiri
