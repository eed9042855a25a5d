// SPDX-License-Identifier: MIT
#include "core/creases/line_tree.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

/// Lines that may share a box; fewer make boxes dearer than pairs.
constexpr std::size_t kFewLines = 10;
/// Deeper than medians ever need.
constexpr int kDeepest = 60;
/// Lines that may be copied into several boxes before no box is divided any more: bundles of long
/// lines close together are parted by no box.
constexpr std::size_t kMostCopies = 4'000'000;
/// Boxes between two reports of progress.
constexpr std::size_t kLeavesPerReport = 1024;

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

class TreeWalk {
 public:
  TreeWalk(const LineMap& map, double margin) : map_(map), margin_(margin) {
    double largest = 0;
    for (const Vec2 p : map.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    // Wide enough that rounding never keeps a line out of a box that it comes into.
    margin_ += 64 * std::numeric_limits<double>::epsilon() * largest;
  }

  /// Pushes the halves of a box; false when it is better looked into as it is.
  bool divide(TreeLeaf& node, std::vector<TreeLeaf>& open) {
    if (node.lines.size() <= kFewLines || node.depth >= kDeepest || copies_ > kMostCopies)
      return false;
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

 private:
  bool divideAt(TreeLeaf& node, std::size_t axis, std::vector<double>& middles,
                std::vector<TreeLeaf>& open) {
    const auto median = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
    std::nth_element(middles.begin(), median, middles.end());
    const double at = *median;
    if (!(at > node.box.low[axis]) || !(at < node.box.high[axis])) return false;
    TreeLeaf low;
    TreeLeaf high;
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
    copies_ += low.lines.size() + high.lines.size() - n;
    for (const std::uint32_t p : node.points)
      (coordinate(map_.points[p], axis) < at ? low : high).points.push_back(p);
    open.push_back(std::move(high));
    open.push_back(std::move(low));
    return true;
  }

  const LineMap& map_;
  double margin_;
  std::size_t copies_ = 0;
};

}  // namespace

Status visitLeaves(const LineMap& map, std::vector<std::uint32_t> points, double margin,
                   const std::function<bool(const TreeLeaf&)>& visit, const Progress& progress) {
  TreeWalk walk(map, margin);
  const double all = static_cast<double>(std::max<std::size_t>(points.size(), 1));
  std::vector<TreeLeaf> open(1);
  open[0].points = std::move(points);
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) open[0].lines.push_back(i);
  std::size_t leaves = 0;
  std::size_t done = 0;
  while (!open.empty()) {
    TreeLeaf node = std::move(open.back());
    open.pop_back();
    if (walk.divide(node, open)) continue;
    if (!visit(node)) break;
    done += node.points.size();
    if (leaves++ % kLeavesPerReport == 0 && !goesOn(progress, static_cast<double>(done) / all))
      return Error{ErrorCode::Cancelled, "reading the crease pattern was stopped"};
  }
  return std::monostate{};
}

}  // namespace kiri
