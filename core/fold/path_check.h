// What paper meets when several hinges turn at once.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fold/movement.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// Appends to the collisions of `end` what the paper meets on the way along the path of an
/// Unfolding from `movement.start`, where all facets may move and no closed form tells: it is
/// looked at as it leaves, at moments no more than two degrees of the fastest hinge apart, and as
/// it arrives. Paper that meets and parts between two moments is not seen. `leading`: the fold line
/// whose angle is told.
void notePathCollisions(const Movement& movement, FoldLineId leading, FoldedState& end);

}  // namespace kiri
