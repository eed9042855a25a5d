// What paper meets when several hinges turn at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/fold/movement.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// What the paper meets on the way of an Unfolding: the first meeting (or what comes so near that
/// nobody can tell), see checkPath; empty when the way is free. `leading`: the fold line whose
/// angle is told.
std::vector<Collision> collisionsOnTheWay(const Movement& movement, FoldLineId leading);

/// What is wrong where the movement ends, in `end`: paper that stands in paper, and hinges against
/// the layer order.
std::vector<Collision> collisionsAtTheEnd(const Movement& movement, FoldLineId leading,
                                          const FoldedState& end);

/// Both, appended to the collisions of `end`.
void notePathCollisions(const Movement& movement, FoldLineId leading, FoldedState& end);

}  // namespace kiri
