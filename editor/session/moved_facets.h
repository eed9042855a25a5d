// Which paper lies elsewhere than before.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// For each facet of `after`: true when its paper lay otherwise in `before`, or was not there. The
/// sheet is the same; the pattern of `after` may be finer or coarser. Cost: near-linear.
std::vector<bool> movedFacets(const FoldedState& before, const FoldedState& after);

/// The facets of a state that hold the places (paper frame), each once, ascending. Cost:
/// near-linear in facets and places together.
std::vector<FacetId> facetsHolding(const CreasePattern& pattern, const std::vector<Vec2>& places);

}  // namespace kiri
