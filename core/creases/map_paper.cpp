// SPDX-License-Identifier: MIT
#include "core/creases/map_paper.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "core/creases/near_points.h"

namespace kiri {
namespace {

constexpr std::uint32_t kNotReached = 0xFFFFFFFF;

bool isFiniteFace(const std::vector<Vec2>& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

double doubleAreaOf(const std::vector<Vec2>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  return sum;
}

/// Half-lines by their ends.
class HalfLineFinder {
 public:
  explicit HalfLineFinder(const LineMap& map) {
    for (std::uint32_t i = 0; i < map.lines.size(); ++i) {
      ends_.push_back({{map.lines[i].from, map.lines[i].to}, 2 * i});
      ends_.push_back({{map.lines[i].to, map.lines[i].from}, 2 * i + 1});
    }
    std::sort(ends_.begin(), ends_.end());
  }
  std::optional<std::uint32_t> between(std::uint32_t from, std::uint32_t to) const {
    const std::pair<std::uint32_t, std::uint32_t> wanted{from, to};
    const auto it = std::lower_bound(ends_.begin(), ends_.end(), std::pair{wanted, 0U});
    if (it == ends_.end() || it->first != wanted) return std::nullopt;
    return it->second;
  }

 private:
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> ends_;
};

/// The face of the map that lies inside a drawn face, if the map has a line along each of some of
/// its sides and they agree.
std::optional<std::uint32_t> faceInside(const MapFaces& faces, const HalfLineFinder& finder,
                                        const NearPoints& places,
                                        const std::vector<Vec2>& corners) {
  if (corners.size() < 3 || !isFiniteFace(corners)) return std::nullopt;
  const bool isClockwise = doubleAreaOf(corners) < 0;
  std::optional<std::uint32_t> inside;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::optional<std::uint32_t> from = places.nearest(corners[i]);
    std::optional<std::uint32_t> to = places.nearest(corners[(i + 1) % corners.size()]);
    if (!from || !to || *from == *to) continue;
    if (isClockwise) std::swap(from, to);
    const std::optional<std::uint32_t> half = finder.between(*from, *to);
    if (!half) continue;
    const std::uint32_t face = faces.faceOf[*half];
    if (inside && *inside != face) return std::nullopt;
    inside = face;
  }
  return inside;
}

bool maySeparatePaper(Assignment assignment) {
  return assignment == Assignment::Border || assignment == Assignment::Cut;
}

}  // namespace

std::vector<bool> paperWithin(const LineMap& map, const MapFaces& faces, Assignment rim) {
  std::vector<std::vector<std::uint32_t>> ways(faces.count());
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) {
    if (faces.left(i) == faces.right(i)) continue;
    ways[faces.left(i)].push_back(2 * i + 1);
    ways[faces.right(i)].push_back(2 * i);
  }
  std::vector<std::uint32_t> level(faces.count(), kNotReached);
  std::deque<std::uint32_t> open{0};
  level[0] = 0;
  std::vector<bool> isDone(faces.count(), false);
  while (!open.empty()) {
    const std::uint32_t face = open.front();
    open.pop_front();
    if (isDone[face]) continue;
    isDone[face] = true;
    for (const std::uint32_t half : ways[face]) {
      const bool isBorder = map.lines[half / 2].assignment == rim;
      const std::uint32_t other = faces.faceOf[half];
      const std::uint32_t reached = level[face] + (isBorder ? 1 : 0);
      if (reached >= level[other]) continue;
      level[other] = reached;
      if (isBorder) {
        open.push_back(other);
      } else {
        open.push_front(other);
      }
    }
  }
  std::vector<bool> isPaper(faces.count(), false);
  for (std::size_t f = 0; f < level.size(); ++f) isPaper[f] = level[f] % 2 == 1;
  return isPaper;
}

PaperOfFaces paperOfFaces(const LineMap& map, const MapFaces& faces,
                          const std::vector<std::vector<Vec2>>& drawn, double within) {
  PaperOfFaces paper;
  paper.isPaper.assign(faces.count(), false);
  const HalfLineFinder finder(map);
  NearPoints places(map.points.empty() ? Vec2{} : map.points.front(), within);
  for (const Vec2 p : map.points) places.add(p);
  std::vector<std::uint32_t> drawnAs(faces.count(), kNotReached);
  for (std::uint32_t i = 0; i < drawn.size(); ++i) {
    const std::optional<std::uint32_t> inside = faceInside(faces, finder, places, drawn[i]);
    if (!inside || *inside == 0) {
      paper.misfits.push_back(i);
    } else {
      paper.isPaper[*inside] = true;
      drawnAs[*inside] = i;
    }
  }
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    const std::uint32_t left = faces.left(i);
    const std::uint32_t right = faces.right(i);
    if (paper.isPaper[left] == paper.isPaper[right]) continue;
    if (maySeparatePaper(map.lines[i].assignment)) continue;
    paper.misfits.push_back(drawnAs[paper.isPaper[left] ? left : right]);
  }
  std::sort(paper.misfits.begin(), paper.misfits.end());
  paper.misfits.erase(std::unique(paper.misfits.begin(), paper.misfits.end()), paper.misfits.end());
  return paper;
}

}  // namespace kiri
