// Measures of regions: area, perimeter, box, convexity, a point inside.
// SPDX-License-Identifier: MIT
#include "core/geometry/region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/check.h"
#include "core/geometry/bounds.h"
#include "core/geometry/convex.h"

namespace kiri {
namespace {

/// The arc seen from `origin`: areas near zero lose less to rounding so.
Arc movedBy(const Arc& arc, Vec2 by) {
  return {arc.start + by, arc.end + by, arc.isCurved, arc.control1 + by, arc.control2 + by};
}

/// Centre of area of a convex polygon.
Vec2 centroid(const std::vector<Vec2>& polygon) {
  const Vec2 origin = polygon[0];
  Vec2 sum;
  double area = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - origin;
    const Vec2 b = polygon[i + 1] - origin;
    const double doubled = cross(a, b);
    sum = sum + (a + b) * doubled;
    area += doubled;
  }
  KIRI_CHECK(area > 0, "a point inside is asked for only where there is area");
  return origin + sum / (3 * area);
}

double perimeterOf(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return sum;
}

/// How roomy a convex polygon is: half of its inner radius or more.
double roomOf(const std::vector<Vec2>& polygon) {
  return signedArea(polygon) / perimeterOf(polygon);
}

/// How far the corner between two sides bulges inwards, mm; 0 at a convex corner.
double dentOf(Vec2 before, Vec2 corner, Vec2 after) {
  const double turn = cross(corner - before, after - corner);
  return turn >= 0 ? 0 : -turn / distance(before, after);
}

/// Upwards or level to the right; what is level but for rounding counts as level.
bool pointsUp(Vec2 d, double nearness) { return std::abs(d.y) <= nearness ? d.x > 0 : d.y > 0; }

}  // namespace

double signedAreaOf(const Loop& loop) {
  if (loop.empty()) return 0;
  const Vec2 origin = loop.front().start;
  double sum = 0;
  for (const Arc& arc : loop) sum += doubleArea(movedBy(arc, -origin));
  return sum / 2;
}

double areaOf(const Region& region) {
  double sum = 0;
  for (const Loop& loop : region.loops) sum += signedAreaOf(loop);
  return sum;
}

double perimeterOf(const Region& region, double tolerance) {
  double sum = 0;
  for (const Loop& loop : region.loops) {
    for (const Arc& arc : loop) sum += lengthOf(arc, tolerance);
  }
  return sum;
}

Box boundsOf(const Region& region) {
  KIRI_CHECK(!region.loops.empty() && !region.loops[0].empty(), "a region has a border");
  return boundsOf(region.loops[0]);
}

bool isConvexPolygon(const Region& region, const Tolerance& tolerance) {
  if (region.loops.size() != 1 || region.loops[0].size() < 3) return false;
  const Loop& loop = region.loops[0];
  double dents = 0;  // together, so that many small ones do not hide a hollow
  int turns = 0;     // changes between going up and going down: two for one round
  const Arc* last = &loop.back();
  if (last->isCurved) return false;
  for (const Arc& arc : loop) {
    if (arc.isCurved) return false;
    const Vec2 before = last->end - last->start;
    const Vec2 after = arc.end - arc.start;
    if (cross(before, after) <= 0 && dot(before, after) <= 0) return false;  // a spike
    dents += dentOf(last->start, arc.start, arc.end);
    if (dents > tolerance.length()) return false;
    if (pointsUp(before, tolerance.length()) != pointsUp(after, tolerance.length())) ++turns;
    last = &arc;
  }
  return turns == 2;
}

Vec2 interiorPoint(const Region& region, const Tolerance& tolerance) {
  std::vector<ConvexPart> parts = convexParts(region, tolerance);
  KIRI_CHECK(!parts.empty(), "a point inside is asked for only where there is area");
  if (parts.size() == 1) return centroid(parts[0].points);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < parts.size(); ++i) order.emplace_back(-roomOf(parts[i].points), i);
  std::sort(order.begin(), order.end());
  for (const auto& [room, i] : order) {
    // Parts are flattened: of a thin one the middle may lie outside of the curve.
    const Vec2 p = centroid(parts[i].points);
    if (locate(region, p, tolerance.length()) == Where::Inside) return p;
  }
  return centroid(parts[order[0].second].points);
}

}  // namespace kiri
