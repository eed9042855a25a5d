// The convex hull of points.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// The corners of the least convex polygon that holds the points, counter-clockwise, from the
/// leftmost (then lowest); points on its sides are left out. Exact orientation. Fewer than three
/// corners where all points lie on one line.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

}  // namespace kiri
