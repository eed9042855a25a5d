// How near two ends of a drawing lie when one vertex is meant.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/line_map.h"

namespace kiri {

/// The distance that the drawing itself suggests. Lines that meet without crossing or touching
/// need none beyond rounding. Else ends that hang loose tell how far lines miss each other, lengths
/// of lines how small true things are; the distance lies in the widest gap between the two, and
/// never beyond 1/300 of the sheet. Errors: those of meetingsOf.
Result<double> mergeDistanceOf(const std::vector<DrawnCrease>& lines, const RepairScale& scale,
                               const Progress& progress);

}  // namespace kiri
