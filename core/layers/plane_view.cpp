// SPDX-License-Identifier: MIT
#include "core/layers/plane_view.h"

#include <algorithm>

#include "core/geometry/convex.h"

namespace kiri {
namespace {

bool doTouch(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

Box boxOf(const std::vector<std::vector<Vec2>>& parts) {
  Box box{parts.front().front(), parts.front().front()};
  for (const auto& part : parts) {
    for (const Vec2 p : part) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
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
    result.parts.push_back(std::move(points));
  }
  result.box = boxOf(result.parts);
  return result;
}

bool PlaneView::doOverlap(FacetId a, FacetId b) {
  const Footprint& first = footprint(a);
  const Footprint& second = footprint(b);
  if (!doTouch(first.box, second.box)) return false;
  for (const auto& p : first.parts) {
    for (const auto& q : second.parts) {
      if (overlap(p, q, tolerance().fat())) return true;
    }
  }
  return false;
}

bool PlaneView::doOverlapLeftOf(FacetId f, FacetId g, Vec2 a, Vec2 direction) {
  const Footprint& first = footprint(f);
  const Footprint& second = footprint(g);
  if (!doTouch(first.box, second.box)) return false;
  for (const auto& p : first.parts) {
    const std::vector<Vec2> half = clipLeft(p, a, a + direction, tolerance().length());
    if (half.size() < 3) continue;
    for (const auto& q : second.parts) {
      if (overlap(half, q, tolerance().fat())) return true;
    }
  }
  return false;
}

}  // namespace kiri
