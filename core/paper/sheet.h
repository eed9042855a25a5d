// The uncut paper at rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/geometry/region.h"
#include "core/geometry/tolerance.h"

namespace kiri {

/// The outline of the uncut paper in the paper frame, mm, y up, front towards the viewer.
struct Sheet {
  Region outline;

  /// Tolerances that fit this sheet's size.
  Tolerance tolerance() const;
};

/// Sheets with the lower left corner (or the box of the disc) at the origin.
/// Errors: BadValue - a size that is not a positive finite number of mm.
Result<Sheet> rectangleSheet(double width, double height);
Result<Sheet> squareSheet(double side);
/// A disc; its border is 32 cubic pieces that stay within 1e-9 of the radius of the true circle.
Result<Sheet> discSheet(double radius);
/// A simple polygon with holes; loops in either direction, they are turned as a region needs them.
/// Errors: BadValue - fewer than three corners, crossing or touching sides, a hole outside, no
/// area.
Result<Sheet> polygonSheet(const std::vector<Vec2>& outline,
                           const std::vector<std::vector<Vec2>>& holes = {});

}  // namespace kiri
