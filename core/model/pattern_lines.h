// The fold lines of a whole crease pattern.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/paper/folded_state.h"

namespace kiri {

/// Gives every hinge whose entry of `targets` (degrees, by edge) is not 0 a fold line: hinges that
/// go on straight through vertices and turn by equal degrees are one line, in whichever direction
/// each of them folds. They are named "NAME 1", "NAME 2", in the order of their lowest edges, and
/// are folded by what the target says when they are refolded. The side that moves is the one
/// without the facet `resting`.
void makeFoldLines(FoldedState& state, const std::vector<double>& targets, FacetId resting,
                   const std::string& name);

}  // namespace kiri
