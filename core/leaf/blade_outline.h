// A sheet cut roughly around the blade.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/leaf/margin.h"

namespace kiri {

/// The border of a sheet that is a little larger than the blade, on the right half. On a large
/// sheet the creases of secondary lobes would run into those of their neighbours; here each ends
/// first.
struct BladeOutline {
  std::vector<Vec2> places;       ///< flat half, from the mid-vein to the basal edge
  std::vector<std::size_t> ends;  ///< by crease: the place where it leaves the sheet
};

/// As much room around the margin as the creases allow. Errors: BadValue - creases that meet, or
/// nearly, where they leave the blade.
Result<BladeOutline> bladeOutline(const FoldedHalf& half, const MarginCurve& curve);

}  // namespace kiri
