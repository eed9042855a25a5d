// Applying a PatternStep: creases, fold lines, folded angles and layers.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fold/movement.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The sheet with the creases of a pattern. Errors: those of creasedSheet.
Result<FoldedState> applyPattern(const FoldedState& state, const PatternStep& step,
                                 Movements* record = nullptr);

/// Writes what the step left open into it: the facet that rests, and where it is folded, the layer
/// order of `after`, the state that it led to.
void nameLayers(const FoldedState& after, PatternStep& step);

/// The name that a step gives its fold lines, without the number.
std::string linesName(const PatternStep& step);

}  // namespace kiri
