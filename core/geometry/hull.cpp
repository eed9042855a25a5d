// The convex hull of points (Andrew's monotone chain).
// SPDX-License-Identifier: MIT
#include "core/geometry/hull.h"

#include <algorithm>

#include "core/geometry/orientation.h"

namespace kiri {
namespace {

/// Appends the chain along [from, to), each corner a left turn; the last point is left to the next
/// chain.
template <class Iterator>
void appendChain(Iterator from, Iterator to, std::vector<Vec2>& hull) {
  const std::size_t base = hull.size();
  for (auto it = from; it != to; ++it) {
    while (hull.size() >= base + 2 && orientation(hull[hull.size() - 2], hull.back(), *it) <= 0) {
      hull.pop_back();
    }
    hull.push_back(*it);
  }
  hull.pop_back();
}

}  // namespace

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  appendChain(points.begin(), points.end(), hull);
  appendChain(points.rbegin(), points.rend(), hull);
  return hull;
}

}  // namespace kiri
