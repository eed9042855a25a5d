// Overlap of polygons in a plane by slabs.
// SPDX-License-Identifier: MIT
#include "tests/support/plane_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kiri::test {
namespace {

using Side = std::pair<Vec2, Vec2>;

std::vector<Side> sidesOf(const Loops& loops) {
  std::vector<Side> sides;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      sides.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
  }
  return sides;
}

double heightAt(const Side& side, double x) {
  const double t = (x - side.first.x) / (side.second.x - side.first.x);
  return side.first.y * (1 - t) + side.second.y * t;
}

/// x of the crossing of two sides inside both, if there is one.
void addCrossing(const Side& a, const Side& b, std::vector<double>& xs) {
  const Vec2 d = a.second - a.first;
  const Vec2 e = b.second - b.first;
  const double turn = cross(d, e);
  if (turn == 0) return;
  const double t = cross(b.first - a.first, e) / turn;
  const double u = cross(b.first - a.first, d) / turn;
  if (t > 0 && t < 1 && u > 0 && u < 1) xs.push_back(a.first.x + t * d.x);
}

/// Heights at which the polygon is entered and left along the vertical line at x, which meets no
/// corner.
std::vector<double> heightsAt(const std::vector<Side>& sides, double x) {
  std::vector<double> heights;
  for (const Side& side : sides) {
    if ((side.first.x < x) != (side.second.x < x)) heights.push_back(heightAt(side, x));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

using Spans = std::vector<std::pair<double, double>>;

Spans spansOf(const std::vector<double>& heights) {
  Spans spans;
  for (std::size_t i = 0; i + 1 < heights.size(); i += 2)
    spans.emplace_back(heights[i], heights[i + 1]);
  return spans;
}

Spans commonSpans(const Spans& a, const Spans& b) {
  Spans common;
  for (const auto& [low, high] : a) {
    for (const auto& [other, top] : b) {
      const double from = std::max(low, other);
      const double to = std::min(high, top);
      if (from < to) common.emplace_back(from, to);
    }
  }
  return common;
}

std::vector<double> slabBordersOf(const std::vector<std::vector<Side>>& polygons) {
  std::vector<double> xs;
  std::vector<Side> all;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  for (const std::vector<Side>& sides : polygons) {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (const Side& side : sides) {
      left = std::min(left, side.first.x);
      right = std::max(right, side.first.x);
      all.push_back(side);
      xs.push_back(side.first.x);
    }
    low = std::max(low, left);
    high = std::min(high, right);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) addCrossing(all[i], all[j], xs);
  }
  std::sort(xs.begin(), xs.end());
  std::vector<double> kept;
  for (const double x : xs) {
    if (x >= low && x <= high && (kept.empty() || x > kept.back())) kept.push_back(x);
  }
  return kept;
}

void addSlab(Common& common, const Spans& spans, double left, double right) {
  for (const auto& [low, high] : spans) {
    if (common.area == 0) {
      common.low = {left, low};
      common.high = {right, high};
    }
    common.area += (right - left) * (high - low);
    common.low = {std::min(common.low.x, left), std::min(common.low.y, low)};
    common.high = {std::max(common.high.x, right), std::max(common.high.y, high)};
  }
}

Vec2 onEdge(const CreasePattern& pattern, const Edge& edge, double t) {
  const Vec2 p0 = pattern[edge.from];
  const Vec2 p3 = pattern[edge.to];
  if (!edge.isCurved()) return lerp(p0, p3, t);
  const CurveControls& c = pattern.curves[edge.curve];
  const double s = 1 - t;
  return p0 * (s * s * s) + c.control1 * (3 * s * s * t) + c.control2 * (3 * s * t * t) +
         p3 * (t * t * t);
}

}  // namespace

Loops flatLoopsOf(const CreasePattern& pattern, FacetId facet, int pieces) {
  Loops loops;
  const Facet& f = pattern[facet];
  for (std::size_t i = 0; i < f.border.size(); ++i) {
    const auto& starts = f.holeStarts;
    if (i == 0 || std::find(starts.begin(), starts.end(), i) != starts.end()) loops.emplace_back();
    const Edge& edge = pattern[f.border[i].edge];
    const int count = edge.isCurved() ? pieces : 1;
    for (int k = 0; k < count; ++k) {
      const double t = static_cast<double>(k) / count;
      loops.back().push_back(onEdge(pattern, edge, f.border[i].isReversed ? 1 - t : t));
    }
  }
  return loops;
}

PlaneFrame frameOf(Vec3 normal, Vec3 origin) {
  const Vec3 n = normalized(normal);
  const Vec3 helper = std::abs(n.z) > 0.5 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 u = normalized(helper - n * dot(helper, n));
  return {origin, u, cross(n, u)};
}

Loops placed(const Loops& loops, const Rigid& pose, const PlaneFrame& frame) {
  Loops moved = loops;
  for (std::vector<Vec2>& loop : moved) {
    for (Vec2& p : loop) p = frame.flatten(pose.apply(p));
  }
  return moved;
}

double areaOf(const Loops& loops) { return commonOf({&loops}).area; }

bool contains(const Loops& loops, Vec2 point) {
  bool isInside = false;
  for (const auto& [a, b] : sidesOf(loops)) {
    if ((a.x < point.x) != (b.x < point.x) && heightAt({a, b}, point.x) > point.y)
      isInside = !isInside;
  }
  return isInside;
}

double Common::fatness() const {
  if (area <= 0) return 0;
  return area / (2 * (high.x - low.x + high.y - low.y));
}

Common commonOf(const std::vector<const Loops*>& polygons) {
  std::vector<std::vector<Side>> sides;
  for (const Loops* loops : polygons) sides.push_back(sidesOf(*loops));
  const std::vector<double> xs = slabBordersOf(sides);
  Common common;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    const double middle = (xs[i] + xs[i + 1]) / 2;
    if (middle <= xs[i] || middle >= xs[i + 1]) continue;
    Spans spans = spansOf(heightsAt(sides[0], middle));
    for (std::size_t k = 1; k < sides.size() && !spans.empty(); ++k) {
      spans = commonSpans(spans, spansOf(heightsAt(sides[k], middle)));
    }
    addSlab(common, spans, xs[i], xs[i + 1]);
  }
  return common;
}

}  // namespace kiri::test
