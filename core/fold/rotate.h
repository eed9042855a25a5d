// The one primitive that moves paper: rotating some facets about an axis.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/fold/movement.h"
#include "core/layers/relayer.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The state after the facets for which `moves` is true have made the motion. Fold angles of the
/// hinges on the axis follow; poses and layer order are renewed; what collides is added to the
/// collisions, the movement to `record` where there is one. Requires: every hinge between a moving
/// and a resting facet lies on the axis (see movingFacets).
FoldedState rotate(FoldedState state, const std::vector<bool>& moves, const Motion& motion,
                   Movements* record = nullptr);

/// The same, but nobody looks for collisions: a moment of a motion that was looked at as a whole.
FoldedState turned(FoldedState state, const std::vector<bool>& moves, const Motion& motion);

/// The whole model moved by a rigid motion: nothing changes but where it lies.
FoldedState placed(FoldedState state, const Rigid& motion);

/// By how much the angle of a hinge grows when its left (or right) facet makes the motion and the
/// other rests: +1 or -1 times the degrees.
int turnSign(const FoldedState& state, const Edge& edge, const Motion& motion, bool leftMoves);

}  // namespace kiri
