// Moments and hulls of contours.
// SPDX-License-Identifier: MIT
#include "core/leaf/outline_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/convex.h"
#include "core/geometry/hull.h"

namespace kiri {
namespace {

/// Integrals over a region: 1, x and y, and about the centroid xx, xy and yy.
struct Moments {
  double area = 0;
  Vec2 centroid;
  double xx = 0;
  double xy = 0;
  double yy = 0;
};

Moments momentsOf(const std::vector<std::vector<Vec2>>& loops) {
  Moments m;
  const Vec2 origin = loops.front().front();
  Vec2 sum;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i] - origin;
      const Vec2 b = loop[(i + 1) % loop.size()] - origin;
      const double twice = cross(a, b);
      m.area += twice / 2;
      sum = sum + (a + b) * (twice / 6);
    }
  }
  m.centroid = origin + sum / m.area;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i] - m.centroid;
      const Vec2 b = loop[(i + 1) % loop.size()] - m.centroid;
      const double twice = cross(a, b);
      m.xx += twice * (a.x * a.x + a.x * b.x + b.x * b.x) / 12;
      m.yy += twice * (a.y * a.y + a.y * b.y + b.y * b.y) / 12;
      m.xy += twice * (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y) / 24;
    }
  }
  return m;
}

/// Axes of the ellipse with the area of the shape and the ratio of its moments.
void fitEllipse(OutlineShape& shape, const Moments& m) {
  const double middle = (m.xx + m.yy) / 2;
  const double apart = std::hypot((m.xx - m.yy) / 2, m.xy);
  const double ratio = std::sqrt((middle + apart) / (middle - apart));
  shape.minor = std::sqrt(4 * shape.area / (std::numbers::pi * ratio));
  shape.major = ratio * shape.minor;
}

void measureHull(OutlineShape& shape, const std::vector<Vec2>& outer) {
  const std::vector<Vec2> hull = convexHull(outer);
  shape.hullArea = signedArea(hull);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    shape.hullPerimeter += distance(hull[i], hull[(i + 1) % hull.size()]);
    for (std::size_t j = 0; j < i; ++j)
      shape.feret = std::max(shape.feret, distance(hull[i], hull[j]));
  }
}

}  // namespace

std::vector<Vec2> flattened(const Loop& contour, const Tolerance& tolerance) {
  std::vector<Vec2> points;
  for (const Arc& arc : contour) {
    for (const double t : flatteningParameters(arc, tolerance.flattening())) {
      if (t < 1) points.push_back(pointAt(arc, t));
    }
  }
  return points;
}

OutlineShape shapeOf(const std::vector<Loop>& contours, const Tolerance& tolerance) {
  OutlineShape shape;
  std::vector<std::vector<Vec2>> loops;
  for (const Loop& contour : contours) {
    shape.area += signedAreaOf(contour);
    loops.push_back(flattened(contour, tolerance));
  }
  for (const Arc& arc : contours.front()) shape.perimeter += lengthOf(arc, tolerance.match());
  const Moments moments = momentsOf(loops);
  shape.centroid = moments.centroid;
  fitEllipse(shape, moments);
  measureHull(shape, loops.front());
  return shape;
}

}  // namespace kiri
