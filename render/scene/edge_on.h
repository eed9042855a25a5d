// Paper that is seen edge-on: a line.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"
#include "render/visibility/projection.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

/// The borders of facets that are seen edge-on and so have no visible part, view coordinates.
std::vector<SeenArc> edgeOnBorders(const FoldedState& state, const ViewFrame& view);

/// Those parts of them that nothing of `regions` hides.
std::vector<Arc> edgeOnLines(const FoldedState& state, const VisibleRegions& regions,
                             const ViewFrame& view);

}  // namespace kiri
