// SPDX-License-Identifier: MIT
#include "core/creases/line_meetings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/base/text.h"
#include "core/geometry/orientation.h"

namespace kiri {
namespace {

/// Lines that few share a box; fewer make boxes dearer than pairs.
constexpr std::size_t kFewLines = 10;
/// Beyond this no median divides what is left.
constexpr int kDeepest = 60;
/// A pattern of 100,000 creases has fewer crossings, whatever is drawn.
constexpr std::size_t kMostMeetings = 3'000'000;
/// Pairs that are looked at before a drawing counts as hatching.
constexpr std::size_t kMostPairs = 600'000'000;

/// A half-open box of the plane.
struct TreeBox {
  std::array<double, 2> low{-std::numeric_limits<double>::max(),
                            -std::numeric_limits<double>::max()};
  std::array<double, 2> high{std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::max()};

  bool holds(Vec2 p) const {
    return p.x >= low[0] && p.x < high[0] && p.y >= low[1] && p.y < high[1];
  }
};

double coordinate(Vec2 p, std::size_t axis) { return axis == 0 ? p.x : p.y; }

/// The part of a line inside a box, as parameters; empty when the first is the larger.
struct ClippedLine {
  double first = 0;
  double last = 1;
  bool isEmpty() const { return first > last; }
};

ClippedLine clip(Vec2 from, Vec2 to, const TreeBox& box, double margin) {
  ClippedLine part;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double start = coordinate(from, axis);
    const double way = coordinate(to, axis) - start;
    const double low = box.low[axis] - margin;
    const double high = box.high[axis] + margin;
    if (way == 0) {
      if (start < low || start > high) return {1, 0};
      continue;
    }
    const double a = (low - start) / way;
    const double b = (high - start) / way;
    part.first = std::max(part.first, std::min(a, b));
    part.last = std::min(part.last, std::max(a, b));
  }
  return part;
}

struct TreeNode {
  TreeBox box;
  std::vector<std::uint32_t> lines;
  std::vector<std::uint32_t> points;
  int depth = 0;
};

class MeetingFinder {
 public:
  MeetingFinder(const LineMap& map, double within, const Progress& progress)
      : map_(map), within_(within), progress_(progress) {
    double largest = 0;
    for (const Vec2 p : map.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    // Wide enough that rounding never puts a crossing into a box without its lines.
    margin_ = 2 * within + 64 * std::numeric_limits<double>::epsilon() * largest;
  }

  Result<LineMeetings> find() {
    TreeNode root;
    for (std::uint32_t i = 0; i < map_.lines.size(); ++i) root.lines.push_back(i);
    std::vector<bool> isUsed(map_.points.size(), false);
    for (const MapLine& line : map_.lines) isUsed[line.from] = isUsed[line.to] = true;
    for (std::uint32_t i = 0; i < map_.points.size(); ++i) {
      if (isUsed[i]) root.points.push_back(i);
    }
    const double all = static_cast<double>(std::max<std::size_t>(root.points.size(), 1));
    std::vector<TreeNode> open;
    open.push_back(std::move(root));
    std::size_t leaves = 0;
    std::size_t donePoints = 0;
    while (!open.empty()) {
      TreeNode node = std::move(open.back());
      open.pop_back();
      if (divide(node, open)) continue;
      lookInto(node);
      donePoints += node.points.size();
      if (isTooMuch_) return tooMany();
      if (++leaves % 1024 == 0 && !goesOn(progress_, static_cast<double>(donePoints) / all))
        return Error{ErrorCode::Cancelled, "reading the crease pattern was stopped"};
    }
    sortAll();
    return std::move(found_);
  }

 private:
  /// Pushes the halves of a node; false when it is better looked into as it is.
  bool divide(TreeNode& node, std::vector<TreeNode>& open) {
    if (node.lines.size() <= kFewLines || node.depth >= kDeepest) return false;
    std::array<std::vector<double>, 2> middles;
    for (const std::uint32_t i : node.lines) {
      const Vec2 from = map_.from(map_.lines[i]);
      const Vec2 to = map_.to(map_.lines[i]);
      const ClippedLine part = clip(from, to, node.box, margin_);
      const Vec2 middle = lerp(from, to, (part.first + part.last) / 2);
      middles[0].push_back(middle.x);
      middles[1].push_back(middle.y);
    }
    std::array<double, 2> spread{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [low, high] = std::minmax_element(middles[axis].begin(), middles[axis].end());
      spread[axis] = *high - *low;
    }
    const std::size_t wide = spread[0] >= spread[1] ? 0 : 1;
    return divideAt(node, wide, middles[wide], open) ||
           divideAt(node, 1 - wide, middles[1 - wide], open);
  }

  bool divideAt(TreeNode& node, std::size_t axis, std::vector<double>& middles,
                std::vector<TreeNode>& open) {
    const auto median = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
    std::nth_element(middles.begin(), median, middles.end());
    const double at = *median;
    if (!(at > node.box.low[axis]) || !(at < node.box.high[axis])) return false;
    TreeNode low;
    TreeNode high;
    low.box = high.box = node.box;
    low.box.high[axis] = high.box.low[axis] = at;
    low.depth = high.depth = node.depth + 1;
    for (const std::uint32_t i : node.lines) {
      const Vec2 from = map_.from(map_.lines[i]);
      const Vec2 to = map_.to(map_.lines[i]);
      if (!clip(from, to, low.box, margin_).isEmpty()) low.lines.push_back(i);
      if (!clip(from, to, high.box, margin_).isEmpty()) high.lines.push_back(i);
    }
    // Where nearly all lines go to both sides, dividing only copies them.
    const std::size_t n = node.lines.size();
    if (low.lines.size() == n || high.lines.size() == n) return false;
    if (low.lines.size() + high.lines.size() > n + n * 3 / 4) return false;
    for (const std::uint32_t p : node.points)
      (coordinate(map_.points[p], axis) < at ? low : high).points.push_back(p);
    open.push_back(std::move(high));
    open.push_back(std::move(low));
    return true;
  }

  void lookInto(const TreeNode& node) {
    for (const std::uint32_t point : node.points) {
      for (const std::uint32_t line : node.lines) addTouch(line, point);
    }
    for (std::size_t i = 0; i < node.lines.size(); ++i) {
      for (std::size_t j = i + 1; j < node.lines.size(); ++j)
        addCrossing(node.lines[i], node.lines[j], node.box);
    }
    pairs_ += node.lines.size() * (node.lines.size() + node.points.size());
    isTooMuch_ =
        pairs_ > kMostPairs || found_.touches.size() + found_.crossings.size() > kMostMeetings;
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
    const double t = std::clamp(cross(r - p, s - r) / cross(q - p, s - r), 0.0, 1.0);
    const Vec2 place = p + (q - p) * t;
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return;
    if (box.holds(place)) found_.crossings.push_back({std::min(i, j), std::max(i, j), place});
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

  Error tooMany() const {
    const Vec2 place = found_.crossings.empty() ? Vec2{} : found_.crossings.front().place;
    return Error{ErrorCode::BadFile,
                 "the lines cross more than " + std::to_string(kMostMeetings) +
                     " times, for example near " + text(place) +
                     "; this is a hatching and no crease pattern, draw its creases only",
                 {{place}, {}, {}}};
  }

  const LineMap& map_;
  double within_;
  const Progress& progress_;
  double margin_ = 0;
  LineMeetings found_;
  std::size_t pairs_ = 0;
  bool isTooMuch_ = false;
};

}  // namespace

Result<LineMeetings> meetingsOf(const LineMap& map, double within, const Progress& progress) {
  return MeetingFinder(map, within, progress).find();
}

}  // namespace kiri
