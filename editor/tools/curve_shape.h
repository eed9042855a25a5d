// The splines that hands draw: how many points they need, and what they look like.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/bspline.h"

namespace kiri {

/// The least number of controls of an open or a closed spline.
constexpr std::size_t leastControls(bool isClosed) { return isClosed ? 3 : 4; }

/// Two or three controls as the four of the same line or parabola; more as they are.
std::vector<Vec2> elevated(const std::vector<Vec2>& controls);

/// The arcs of a clamped or closed spline; none with too few controls.
std::vector<Arc> splineOf(const std::vector<Vec2>& controls, bool isClosed);

/// Points along arcs that follow each other: `perArc` steps on each, and the end.
std::vector<Vec2> polyline(const std::vector<Arc>& arcs, int perArc);

}  // namespace kiri
