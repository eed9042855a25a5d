// The shape of an outline, wherever it lies: size, ellipse, convex hull.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/region.h"
#include "core/geometry/tolerance.h"

namespace kiri {

/// mm and mm^2. The ellipse is the one that ImageJ fits: of the area and the second moments of the
/// shape.
struct OutlineShape {
  double area = 0;       ///< without holes
  double perimeter = 0;  ///< of the outer contour
  Vec2 centroid;
  double hullArea = 0;
  double hullPerimeter = 0;
  double major = 0;  ///< axis of the ellipse, from end to end
  double minor = 0;
  double feret = 0;  ///< the greatest distance of two points
};

/// The shape of contours with the paper on their left, the outer one first. Area and perimeter are
/// those of the curves, the rest is of chords within tolerance.flattening().
OutlineShape shapeOf(const std::vector<Loop>& contours, const Tolerance& tolerance);

/// The corners of a contour with its curves as chords.
std::vector<Vec2> flattened(const Loop& contour, const Tolerance& tolerance);

}  // namespace kiri
