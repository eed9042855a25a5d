// SPDX-License-Identifier: MIT
#include "core/creases/outline.h"

#include <algorithm>
#include <tuple>

#include "core/geometry/hull.h"

namespace kiri {
namespace {

/// The points that lines end in, each once, by place.
std::vector<std::uint32_t> sortedEnds(const LineMap& map) {
  std::vector<std::uint32_t> ends;
  for (const MapLine& line : map.lines) {
    ends.push_back(line.from);
    ends.push_back(line.to);
  }
  std::sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec2 p = map.points[a];
    const Vec2 q = map.points[b];
    return std::tie(p.x, p.y, a) < std::tie(q.x, q.y, b);
  });
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
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
  const std::vector<std::uint32_t> ends = sortedEnds(map);
  std::vector<Vec2> places;
  for (const std::uint32_t end : ends) places.push_back(map.points[end]);
  const std::vector<Vec2> corners = convexHull(places);
  if (corners.size() < 3) return {};
  std::vector<std::uint32_t> hull;
  for (const Vec2 corner : corners) {
    const auto at = std::lower_bound(places.begin(), places.end(), corner, [](Vec2 a, Vec2 b) {
      return std::tie(a.x, a.y) < std::tie(b.x, b.y);
    });
    hull.push_back(ends[static_cast<std::size_t>(at - places.begin())]);
  }
  std::vector<MapLine> sides;
  for (std::size_t i = 0; i < hull.size(); ++i)
    sides.push_back({hull[i], hull[(i + 1) % hull.size()], Assignment::Border, std::nullopt});
  return sides;
}

}  // namespace kiri
