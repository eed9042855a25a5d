// Adding edges that nothing folds yet (thesis 4.3).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/paper/facet_line.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// Divides the layers along the segment by flat hinges. In each layer the edge runs from border to
/// border, also where the segment ends between them. Errors: MissesPaper - no layer is crossed;
/// TooThin - see inscribeChords.
Result<FoldedState> addEdge(const FoldedState& state, const FacetLine& line,
                            const std::vector<FacetId>& layers);

}  // namespace kiri
