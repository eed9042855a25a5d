// Which creases lie along a drawn line.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/facet_line.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The hinges that lie on the line in the model frame and share a stretch of its segment, by
/// number; flat or folded, whatever plane their facets lie in.
std::vector<EdgeId> hingesAlong(const FoldedState& state, const FacetLine& line);

}  // namespace kiri
