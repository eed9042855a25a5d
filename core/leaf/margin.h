// The one curve that cuts the folded leaf.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/leaf/fan.h"

namespace kiri {

/// A tip, a sinus or another place that the margin passes, in the folded leaf, seen from the
/// petiole with the innermost sector at rest: degrees clockwise from the mid-vein there, and the
/// distance as part of the mid-vein's length.
struct MarginKnot {
  std::string name;
  double folded = 0;
  double length = 0;
};

/// Where all tips and sinuses lie in the folded leaf, and the further places of the margin. Errors:
/// BadValue - two that no single margin curve can cut, with the remedy: along it lengths must fall
/// as the rays' folded directions turn away from the mid-vein; secondary lobes that would be folded
/// past the mid-vein, or are out of order.
Result<std::vector<MarginKnot>> marginKnots(const LeafRecipe& recipe,
                                            const std::vector<FanRay>& fan);

/// Control points of a clamped uniform cubic B-spline through the knots, smooth between them, and a
/// little beyond the paper at either end. In units of the mid-vein's length; the petiole is the
/// origin, the mid-vein of the innermost sector points along +y. `knots` must be some that
/// marginKnots let pass.
std::vector<Vec2> marginControls(const std::vector<MarginKnot>& knots);

}  // namespace kiri
