// From a stroke of the hand to a B-spline with few control points.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// What a stroke became.
struct FittedCurve {
  std::vector<Vec2> controls;  ///< of openSpline (clamped) or closedSpline
  double error = 0;            ///< no point of the stroke is farther from the curve
};

/// The uniform cubic B-spline that follows a stroke, with about as few controls as keep every point
/// of the stroke within `tolerance`; an open one starts and ends where the stroke does. Least
/// squares by chord length, parameters corrected towards the nearest points (Piegl & Tiller, The
/// NURBS Book, 9.4). Where `mostControls` do not suffice the result is the best found and `error`
/// says how good it is. No controls when the stroke has no length.
FittedCurve fitCurve(const std::vector<Vec2>& stroke, bool isClosed, double tolerance,
                     std::size_t mostControls = 48);

/// Puts one control more into an open clamped or a closed spline, near parameter `at`: arcs of the
/// spline count 1 each. The curve follows the old one as nearly as the count allows.
std::vector<Vec2> withControlAt(const std::vector<Vec2>& controls, bool isClosed, double at);

}  // namespace kiri
