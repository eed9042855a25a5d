// The one curve that cuts the folded leaf.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/leaf/fan.h"

namespace kiri {

/// Control points of a clamped uniform cubic B-spline through the tips and sinuses of the folded
/// leaf, smooth between them, and a little beyond the paper at either end. In units of the
/// mid-vein's length; the petiole is the origin, the mid-vein points along +y, folded directions
/// turn clockwise from it. `fan` must be one that fanOf let pass.
std::vector<Vec2> marginControls(const std::vector<FanRay>& fan);

}  // namespace kiri
