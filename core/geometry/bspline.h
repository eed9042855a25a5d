// Uniform cubic B-splines, the curves that people draw with (thesis 4.4).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/geometry/cubic.h"

namespace kiri {

/// How an open spline ends.
enum class SplineEnds {
  Clamped,  ///< the curve starts at the first control point and ends at the last (end knots of
            ///< multiplicity 4)
  Free,     ///< plain uniform knots: the curve starts near the second control point
};

/// The Bezier pieces of an open uniform cubic B-spline, in order, each starting exactly where the
/// last ended. Requires at least four control points; gives n - 3 pieces.
std::vector<Arc> openSpline(const std::vector<Vec2>& controls, SplineEnds ends);

/// The Bezier pieces of a closed (periodic) uniform cubic B-spline; n pieces for n >= 3 control
/// points.
std::vector<Arc> closedSpline(const std::vector<Vec2>& controls);

}  // namespace kiri
