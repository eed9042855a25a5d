// Loops turn as far left as lines allow at each point; which of them lies in which face is found by
// looking to the left from the leftmost point of each connected group of lines.
// SPDX-License-Identifier: MIT
#include "core/creases/map_faces.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/base/check.h"
#include "core/base/disjoint_sets.h"
#include "core/geometry/orientation.h"

namespace kiri {
namespace {

constexpr std::uint32_t kNoNumber = 0xFFFFFFFF;

class HalfLines {
 public:
  explicit HalfLines(const LineMap& map) : map_(map), places_(2 * map.lines.size()) {
    first_.assign(map.points.size() + 1, 0);
    for (std::uint32_t h = 0; h < places_.size(); ++h) ++first_[start(h) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    around_.resize(places_.size());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t h = 0; h < places_.size(); ++h) around_[fill[start(h)]++] = h;
    for (std::uint32_t p = 0; p < map.points.size(); ++p) {
      std::sort(around_.begin() + first_[p], around_.begin() + first_[p + 1],
                [this](std::uint32_t a, std::uint32_t b) { return turnsBefore(a, b); });
    }
    for (std::uint32_t i = 0; i < around_.size(); ++i) places_[around_[i]] = i;
  }

  std::uint32_t start(std::uint32_t h) const {
    const MapLine& line = map_.lines[h / 2];
    return h % 2 == 0 ? line.from : line.to;
  }
  std::uint32_t end(std::uint32_t h) const { return start(h ^ 1U); }

  /// The half-line that follows along the face on the left: the next one clockwise of the way back.
  std::uint32_t next(std::uint32_t h) const {
    const std::uint32_t back = h ^ 1U;
    const std::uint32_t point = start(back);
    const std::uint32_t at = places_[back];
    return around_[at == first_[point] ? first_[point + 1] - 1 : at - 1];
  }

  /// Half-lines that leave a point, counter-clockwise from straight down.
  std::uint32_t lastAround(std::uint32_t point) const { return around_[first_[point + 1] - 1]; }

 private:
  /// Counter-clockwise from straight down (which comes last), exactly.
  bool turnsBefore(std::uint32_t a, std::uint32_t b) const {
    const Vec2 middle = map_.points[start(a)];
    const Vec2 p = map_.points[end(a)];
    const Vec2 q = map_.points[end(b)];
    const int halfA = halfOf(middle, p);
    const int halfB = halfOf(middle, q);
    if (halfA != halfB) return halfA < halfB;
    const int side = orientation(middle, p, q);
    return side != 0 ? side > 0 : a < b;
  }
  /// 0 for directions from just beyond straight down to straight up, 1 for the others.
  static int halfOf(Vec2 middle, Vec2 p) {
    return p.x > middle.x || (p.x == middle.x && p.y > middle.y) ? 0 : 1;
  }

  const LineMap& map_;
  std::vector<std::uint32_t> first_;  ///< by point: where its half-lines begin in around_
  std::vector<std::uint32_t> around_;
  std::vector<std::uint32_t> places_;  ///< by half-line: where it stands in around_
};

struct TracedLoops {
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::uint32_t> loopOf;  ///< by half-line
};

TracedLoops traceLoops(const HalfLines& halves, std::size_t count) {
  TracedLoops traced;
  traced.loopOf.assign(count, kNoNumber);
  for (std::uint32_t first = 0; first < count; ++first) {
    if (traced.loopOf[first] != kNoNumber) continue;
    const std::uint32_t number = static_cast<std::uint32_t>(traced.loops.size());
    std::vector<std::uint32_t> loop;
    for (std::uint32_t h = first; traced.loopOf[h] == kNoNumber; h = halves.next(h)) {
      traced.loopOf[h] = number;
      loop.push_back(h);
    }
    KIRI_CHECK(halves.end(loop.back()) == halves.start(first), "loops of half-lines close");
    traced.loops.push_back(std::move(loop));
  }
  return traced;
}

/// Lines that hang together, by point: the lowest point of the group.
std::vector<std::uint32_t> groupsOf(const LineMap& map) {
  DisjointSets joined(map.points.size());
  for (const MapLine& line : map.lines) joined.join(line.from, line.to);
  std::vector<std::uint32_t> groups(map.points.size());
  for (std::uint32_t p = 0; p < groups.size(); ++p) groups[p] = joined.find(p);
  return groups;
}

/// Which line lies nearest on the left of some points, for all of them in one sweep from below: the
/// lines at one level stand in an order, for none cross.
class LeftSweep {
 public:
  LeftSweep(const LineMap& map, std::vector<std::uint32_t> points)
      : map_(map), points_(std::move(points)), open_(Order{this}) {}

  /// The half-line on whose left side each point lies (beyond which its face is), by point in the
  /// order given; none where no line lies to the left. A point's own lines, that begin there and
  /// run right or up, do not count.
  std::vector<std::optional<std::uint32_t>> run() {
    std::vector<std::uint32_t> starts(map_.lines.size());
    std::iota(starts.begin(), starts.end(), 0U);
    std::vector<std::uint32_t> ends = starts;
    std::sort(starts.begin(), starts.end(),
              [&](std::uint32_t a, std::uint32_t b) { return isLess(low(a).y, low(b).y, a, b); });
    std::sort(ends.begin(), ends.end(),
              [&](std::uint32_t a, std::uint32_t b) { return isLess(high(a).y, high(b).y, a, b); });
    std::vector<std::uint32_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return isLess(map_.points[points_[a]].y, map_.points[points_[b]].y, a, b);
    });
    std::vector<std::optional<std::uint32_t>> result(points_.size());
    std::size_t start = 0;
    std::size_t end = 0;
    for (const std::uint32_t i : order) {
      const Vec2 p = map_.points[points_[i]];
      // Lines are met at levels from their lower end up to below their upper one. Ends first: at
      // one level the lines that end there and those that begin there have no order.
      while (end < ends.size() && high(ends[end]).y <= p.y) {
        const double level = high(ends[end]).y;
        open(starts, start, level, false);
        close(ends[end++]);
      }
      open(starts, start, p.y, true);
      result[i] = leftOf(p);
    }
    return result;
  }

 private:
  struct Order {
    using is_transparent = void;
    const LeftSweep* sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return sweep->isBefore(a, b); }
    bool operator()(std::uint32_t a, Vec2 p) const { return sweep->isLeftOf(a, p); }
    bool operator()(Vec2 p, std::uint32_t a) const { return sweep->isRightOf(a, p); }
  };

  static bool isLess(double a, double b, std::uint32_t i, std::uint32_t j) {
    return a != b ? a < b : i < j;
  }

  Vec2 low(std::uint32_t i) const {
    const MapLine& line = map_.lines[i];
    return map_.from(line).y < map_.to(line).y ? map_.from(line) : map_.to(line);
  }
  Vec2 high(std::uint32_t i) const {
    const MapLine& line = map_.lines[i];
    return map_.from(line).y < map_.to(line).y ? map_.to(line) : map_.from(line);
  }

  /// Opens lines that begin below a level, or at it.
  void open(const std::vector<std::uint32_t>& starts, std::size_t& next, double level,
            bool isAtLevel) {
    for (; next < starts.size(); ++next) {
      const std::uint32_t i = starts[next];
      if (low(i).y > level || (low(i).y == level && !isAtLevel)) return;
      if (low(i).y < high(i).y) open_.insert(i);
    }
  }
  void close(std::uint32_t i) {
    if (low(i).y < high(i).y) open_.erase(i);
  }

  std::optional<std::uint32_t> leftOf(Vec2 p) const {
    auto it = open_.lower_bound(p);
    if (it == open_.begin()) return std::nullopt;
    const std::uint32_t i = *--it;
    // Upward lines have what lies right of them on their right.
    const MapLine& line = map_.lines[i];
    return 2 * i + (map_.from(line).y < map_.to(line).y ? 1U : 0U);
  }

  bool isLeftOf(std::uint32_t i, Vec2 p) const { return orientation(low(i), high(i), p) < 0; }
  bool isRightOf(std::uint32_t i, Vec2 p) const { return orientation(low(i), high(i), p) > 0; }
  /// Of two lines that meet one level and do not cross: by the end that stands between the other's.
  bool isBefore(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return false;
    const int atLow = low(a).y >= low(b).y ? orientation(low(b), high(b), low(a))
                                           : -orientation(low(a), high(a), low(b));
    if (atLow != 0) return atLow > 0;
    const int atHigh = high(a).y <= high(b).y ? orientation(low(b), high(b), high(a))
                                              : -orientation(low(a), high(a), high(b));
    return atHigh != 0 ? atHigh > 0 : a < b;
  }

  const LineMap& map_;
  std::vector<std::uint32_t> points_;
  std::set<std::uint32_t, Order> open_;
};

/// The leftmost point of each group (of equals the lowest), from left to right.
std::vector<std::uint32_t> leftmostPoints(const LineMap& map,
                                          const std::vector<std::uint32_t>& groups) {
  const auto isLess = [&](std::uint32_t a, std::uint32_t b) {
    const Vec2 p = map.points[a];
    const Vec2 q = map.points[b];
    return p.x != q.x ? p.x < q.x : (p.y != q.y ? p.y < q.y : a < b);
  };
  std::vector<std::uint32_t> best(map.points.size(), kNoNumber);
  const auto offer = [&](std::uint32_t p) {
    std::uint32_t& least = best[groups[p]];
    if (least == kNoNumber || isLess(p, least)) least = p;
  };
  for (const MapLine& line : map.lines) {
    offer(line.from);
    offer(line.to);
  }
  best.erase(std::remove(best.begin(), best.end(), kNoNumber), best.end());
  std::sort(best.begin(), best.end(), isLess);
  return best;
}

}  // namespace

MapFaces facesOf(const LineMap& map) {
  const HalfLines halves(map);
  const TracedLoops traced = traceLoops(halves, 2 * map.lines.size());
  const std::vector<std::uint32_t> groups = groupsOf(map);
  const std::vector<std::uint32_t> leftmost = leftmostPoints(map, groups);
  std::vector<bool> isAround(traced.loops.size(), false);
  for (const std::uint32_t p : leftmost) isAround[traced.loopOf[halves.lastAround(p)]] = true;

  MapFaces faces;
  faces.loops.resize(1);
  std::vector<std::uint32_t> faceOfLoop(traced.loops.size(), 0);
  for (std::uint32_t i = 0; i < traced.loops.size(); ++i) {
    if (isAround[i]) continue;
    faceOfLoop[i] = static_cast<std::uint32_t>(faces.loops.size());
    faces.loops.push_back({traced.loops[i]});
  }
  std::vector<std::optional<std::uint32_t>> seen(leftmost.size());
  if (leftmost.size() > 1) seen = LeftSweep(map, leftmost).run();
  for (std::size_t i = 0; i < leftmost.size(); ++i) {
    const std::uint32_t loop = traced.loopOf[halves.lastAround(leftmost[i])];
    // What lies to the left was given its face before: groups come from left to right.
    if (seen[i]) faceOfLoop[loop] = faceOfLoop[traced.loopOf[*seen[i]]];
    faces.loops[faceOfLoop[loop]].push_back(traced.loops[loop]);
  }
  faces.faceOf.reserve(traced.loopOf.size());
  for (const std::uint32_t loop : traced.loopOf) faces.faceOf.push_back(faceOfLoop[loop]);
  return faces;
}

}  // namespace kiri
