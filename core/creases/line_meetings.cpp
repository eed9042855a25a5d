// SPDX-License-Identifier: MIT
#include "core/creases/line_meetings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/text.h"
#include "core/creases/line_tree.h"
#include "core/geometry/orientation.h"

namespace kiri {
namespace {

/// A pattern of 100,000 creases has fewer meetings, whatever is drawn.
constexpr std::size_t kMostMeetings = 3'000'000;
/// Pairs that are looked at before a drawing counts as hatching.
constexpr std::size_t kMostPairs = 200'000'000;
/// The same for pairs that are only measured.
constexpr std::size_t kMostNearPairs = 50'000'000;

Error hatching(std::optional<Vec2> place = std::nullopt) {
  Error error{ErrorCode::BadFile, {}, {}};
  if (place) error.witness.points = {*place};
  error.message = "the lines lie across each other in millions of places" +
                  (place ? ", for example near " + text(*place) : std::string()) +
                  "; that is a hatching and no crease pattern, leave its lines out";
  return error;
}

std::vector<std::uint32_t> usedPoints(const LineMap& map) {
  std::vector<bool> isUsed(map.points.size(), false);
  for (const MapLine& line : map.lines) isUsed[line.from] = isUsed[line.to] = true;
  std::vector<std::uint32_t> points;
  for (std::uint32_t i = 0; i < isUsed.size(); ++i) {
    if (isUsed[i]) points.push_back(i);
  }
  return points;
}

class MeetingFinder {
 public:
  MeetingFinder(const LineMap& map, double within) : map_(map), within_(within) {}

  Result<LineMeetings> find(const Progress& progress) {
    const Status seen = visitLeaves(
        map_, usedPoints(map_), 2 * within_,
        [this](const TreeLeaf& leaf) { return lookInto(leaf); }, progress);
    if (!seen) return seen.error();
    if (isTooMuch_)
      return found_.crossings.empty() ? hatching() : hatching(found_.crossings.front().place);
    sortAll();
    return std::move(found_);
  }

 private:
  /// False when there are too many.
  bool lookInto(const TreeLeaf& leaf) {
    for (const std::uint32_t point : leaf.points) {
      for (const std::uint32_t line : leaf.lines) addTouch(line, point);
    }
    // A leaf of very many lines that all cross is given up within it.
    for (std::size_t i = 0; i < leaf.lines.size() && !isTooMuch_; ++i) {
      for (std::size_t j = i + 1; j < leaf.lines.size(); ++j)
        addCrossing(leaf.lines[i], leaf.lines[j], leaf.box);
      pairs_ += leaf.lines.size() - i + leaf.points.size();
      isTooMuch_ =
          pairs_ > kMostPairs || found_.touches.size() + found_.crossings.size() > kMostMeetings;
    }
    return !isTooMuch_;
  }

  void addTouch(std::uint32_t index, std::uint32_t point) {
    const MapLine& line = map_.lines[index];
    if (line.from == point || line.to == point) return;
    const Vec2 from = map_.from(line);
    const Vec2 way = map_.to(line) - from;
    const Vec2 offset = map_.points[point] - from;
    const double along = dot(offset, way);
    const double square = dot(way, way);
    if (along <= 0 || along >= square) return;
    if (std::abs(cross(way, offset)) > within_ * std::sqrt(square)) return;
    found_.touches.push_back({index, point, along / square});
  }

  void addCrossing(std::uint32_t i, std::uint32_t j, const TreeBox& box) {
    const MapLine& a = map_.lines[i];
    const MapLine& b = map_.lines[j];
    if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return;
    const Vec2 p = map_.from(a);
    const Vec2 q = map_.to(a);
    const Vec2 r = map_.from(b);
    const Vec2 s = map_.to(b);
    if (std::max(p.x, q.x) < std::min(r.x, s.x) || std::max(r.x, s.x) < std::min(p.x, q.x)) return;
    if (std::max(p.y, q.y) < std::min(r.y, s.y) || std::max(r.y, s.y) < std::min(p.y, q.y)) return;
    if (orientation(p, q, r) * orientation(p, q, s) >= 0) return;
    if (orientation(r, s, p) * orientation(r, s, q) >= 0) return;
    const double t = cross(r - p, s - r) / cross(q - p, s - r);
    // Lines that are parallel to the last digits meet somewhere on what they share.
    const Vec2 place = std::isfinite(t) ? p + (q - p) * std::clamp(t, 0.0, 1.0) : r;
    if (box.holds(place)) found_.crossings.push_back({i, j, place});
  }

  void sortAll() {
    std::sort(found_.touches.begin(), found_.touches.end(),
              [](const LineTouch& a, const LineTouch& b) {
                return std::tie(a.line, a.along, a.point) < std::tie(b.line, b.along, b.point);
              });
    std::sort(found_.crossings.begin(), found_.crossings.end(),
              [](const LineCrossing& a, const LineCrossing& b) {
                return std::tie(a.first, a.second) < std::tie(b.first, b.second);
              });
  }

  const LineMap& map_;
  double within_;
  LineMeetings found_;
  std::size_t pairs_ = 0;
  bool isTooMuch_ = false;
};

double distanceToLine(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const double t = std::clamp(dot(p - from, way) / dot(way, way), 0.0, 1.0);
  return distance(p, from + way * t);
}

}  // namespace

Result<LineMeetings> meetingsOf(const LineMap& map, double within, const Progress& progress) {
  return MeetingFinder(map, within).find(progress);
}

Result<bool> visitNearPairs(const LineMap& map, double farthest,
                            const std::function<void(std::uint32_t, double)>& see,
                            const Progress& progress) {
  std::size_t pairs = 0;
  const auto look = [&](const TreeLeaf& leaf) {
    pairs += leaf.points.size() * leaf.lines.size();
    if (pairs > kMostNearPairs) return false;
    for (const std::uint32_t point : leaf.points) {
      for (const std::uint32_t i : leaf.lines) {
        const MapLine& line = map.lines[i];
        if (line.from == point || line.to == point) continue;
        const double d = distanceToLine(map.points[point], map.from(line), map.to(line));
        if (d <= farthest) see(point, d);
      }
    }
    return true;
  };
  const Status seen = visitLeaves(map, usedPoints(map), farthest, look, progress);
  if (!seen) return seen.error();
  return pairs <= kMostNearPairs;
}

}  // namespace kiri
