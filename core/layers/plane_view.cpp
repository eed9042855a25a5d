// SPDX-License-Identifier: MIT
#include "core/layers/plane_view.h"

#include <algorithm>

#include "core/geometry/bounds.h"
#include "core/geometry/convex.h"

namespace kiri {
namespace {

/// True when test(p, q) is for two parts whose boxes touch. Parts are sorted, so each needs to look
/// at few others.
template <class Test>
bool anyPair(const Footprint& first, const Footprint& second, Test test) {
  if (!areNear(first.box, second.box, 0)) return false;
  for (const FootprintPart& p : first.parts) {
    if (!areNear(p.box, second.box, 0)) continue;
    for (const FootprintPart& q : second.parts) {
      if (q.box.low.x > p.box.high.x) break;
      if (areNear(p.box, q.box, 0) && test(p.points, q.points)) return true;
    }
  }
  return false;
}

}  // namespace

const Footprint& PlaneView::footprint(FacetId facet) {
  const auto [it, isNew] = footprints_.try_emplace(facet.index);
  if (!isNew) return it->second;
  const Rigid& pose = poses_[facet.index];
  const bool isFlipped = dot(pose.normal(), reference_.normal()) < 0;
  Footprint& result = it->second;
  for (const ConvexPart& part : convexParts(regionOf(pattern_, facet), pattern_.tolerance)) {
    std::vector<Vec2> points;
    points.reserve(part.points.size());
    for (const Vec2 p : part.points) points.push_back(toPlane(pose.apply(p)));
    if (isFlipped) std::reverse(points.begin(), points.end());
    const Box box = boundsOf(points);
    result.box = result.parts.empty() ? box : joined(result.box, box);
    result.parts.push_back({std::move(points), box});
  }
  std::stable_sort(
      result.parts.begin(), result.parts.end(),
      [](const FootprintPart& a, const FootprintPart& b) { return a.box.low.x < b.box.low.x; });
  return result;
}

bool PlaneView::doOverlap(FacetId a, FacetId b) {
  const double fat = tolerance().fat();
  return anyPair(
      footprint(a), footprint(b),
      [fat](const std::vector<Vec2>& p, const std::vector<Vec2>& q) { return overlap(p, q, fat); });
}

bool PlaneView::doOverlapLeftOf(FacetId f, FacetId g, Vec2 a, Vec2 direction) {
  const Tolerance& tol = tolerance();
  return anyPair(footprint(f), footprint(g),
                 [&](const std::vector<Vec2>& p, const std::vector<Vec2>& q) {
                   if (!overlap(p, q, tol.fat())) return false;
                   const std::vector<Vec2> half = clipLeft(p, a, a + direction, tol.length());
                   return half.size() >= 3 && overlap(half, q, tol.fat());
                 });
}

}  // namespace kiri
