// Regions as convex parts, with curves as coarse as the caller wants them.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/region.h"

namespace kiri {

/// As convexParts, but polylines may miss their curves by `chordError`, mm, above zero. Both sides
/// of a curve still get the same points.
std::vector<ConvexPart> convexPartsWithin(const Region& region, const Tolerance& tolerance,
                                          double chordError);

}  // namespace kiri
