// SPDX-License-Identifier: MIT
#include "core/creases/outline.h"

#include <algorithm>

#include "core/geometry/orientation.h"

namespace kiri {
namespace {

/// One half of the hull of points that are sorted from left to right: counter-clockwise below when
/// they are run through forwards, above when backwards (Andrew's monotone chain).
template <class Iterator>
void appendChain(const LineMap& map, Iterator first, Iterator last,
                 std::vector<std::uint32_t>& hull) {
  const std::size_t base = hull.size();
  for (Iterator it = first; it != last; ++it) {
    while (hull.size() >= base + 2 && orientation(map.points[hull[hull.size() - 2]],
                                                  map.points[hull.back()], map.points[*it]) <= 0)
      hull.pop_back();
    hull.push_back(*it);
  }
  hull.pop_back();
}

}  // namespace

bool showOutline(const MapFaces& faces, std::size_t lineCount) {
  if (faces.count() < 2) return false;
  for (std::size_t i = 0; i < lineCount; ++i) {
    if (faces.left(i) == 0 && faces.right(i) == 0) return false;
  }
  return true;
}

std::vector<MapLine> hullOf(const LineMap& map) {
  std::vector<std::uint32_t> points;
  for (const MapLine& line : map.lines) {
    points.push_back(line.from);
    points.push_back(line.to);
  }
  std::sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec2 p = map.points[a];
    const Vec2 q = map.points[b];
    return p.x != q.x ? p.x < q.x : (p.y != q.y ? p.y < q.y : a < b);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<std::uint32_t> hull;
  if (points.size() < 3) return {};
  appendChain(map, points.begin(), points.end(), hull);
  appendChain(map, points.rbegin(), points.rend(), hull);
  if (hull.size() < 3) return {};
  std::vector<MapLine> sides;
  for (std::size_t i = 0; i < hull.size(); ++i)
    sides.push_back({hull[i], hull[(i + 1) % hull.size()], Assignment::Border, std::nullopt});
  return sides;
}

}  // namespace kiri
