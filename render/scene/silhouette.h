// The outline of all that is seen.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/region.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

/// The silhouette as loops with the paper on their left, view coordinates.
std::vector<Loop> silhouetteOf(const VisibleRegions& regions);

}  // namespace kiri
