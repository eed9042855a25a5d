// Curves of DXF entities as points.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "io/patterns/dxf_entities.h"

namespace kiri {

/// Points on the arc of an ellipse with half axes `major` and `minor`, from parameter `start` to
/// `end` (radians, counter-clockwise), no farther apart than that the chords stay within
/// `tolerance`.
std::vector<Vec2> ellipsePoints(Vec2 centre, Vec2 major, Vec2 minor, double start, double end,
                                double tolerance);

/// Points on the arc from `from` to `to` whose bulge (tangent of a quarter of its angle, positive
/// counter-clockwise) is given, both ends included, to the last bit.
std::vector<Vec2> bulgePoints(Vec2 from, Vec2 to, double bulge, double tolerance);

/// Points on a SPLINE: of any degree, rational or not; one with fit points only goes straight
/// between them. Empty when the entity makes no sense.
std::vector<Vec2> splinePoints(const DxfEntity& spline, double tolerance);

}  // namespace kiri
