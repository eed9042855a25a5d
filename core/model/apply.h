// Applying steps to states: pure, and the only way a state changes.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fold/movement.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The next state, or what is wrong and where. `number` is the step's place in the model, from 1;
/// it names the fold line of a fold without a name and is noted in collisions. The state is not
/// changed. `record`, where there is one, gets the movements in which the paper goes from one to
/// the other; steps that move nothing, and motions for which the paper would have to bend, have
/// none.
Result<FoldedState> apply(const FoldedState& state, const Step& step, int number,
                          Movements* record = nullptr);

/// The same step with every choice that hung on how the model lies written down as places on the
/// paper: the line in the frame of a named facet, the layers and the moving side as points.
/// Applying it gives the same state.
Result<Step> resolve(const FoldedState& state, const Step& step, int number);

}  // namespace kiri
