// One continuous part of a step: how the paper gets from one state to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "core/layers/relayer.h"
#include "core/linkage/rigid_path.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// Some facets turn about one axis, the others rest.
struct Turning {
  std::vector<bool> moves;
  Motion motion;
};

/// Several hinges turn at once, in proportion or as closed loops of creases demand.
struct Unfolding {
  std::shared_ptr<const RigidPath> path;
  std::vector<Rest> from;  ///< how one facet of each piece lies when it starts,
  std::vector<Rest> to;    ///< and when it ends; the same facets
};

/// The whole model moves: it is turned over, rotated or shifted. `motion` first, then `by`.
struct Carrying {
  Motion motion;
  Vec3 by;
};

/// The pattern does not change on the way: creases and cuts are there when the movement starts.
struct Movement {
  std::shared_ptr<const FoldedState> start;
  std::variant<Turning, Unfolding, Carrying> how;
};

/// Degrees that the fastest hinge turns, or the model; 0 for a mere shift.
double degreesOf(const Movement& movement);

/// The state when `part` (0 to 1) of the movement is done: poses, angles, layer order. Collisions
/// on the way are not looked for; those of the start are kept.
FoldedState stateDuring(const Movement& movement, double part);

/// The poses of that moment only: quicker than stateDuring. Requires an Unfolding.
std::vector<Rigid> posesDuring(const Movement& movement, double part);

/// Collects the movements of steps, for whoever wants them.
using Movements = std::vector<Movement>;

/// Degrees of all of them.
double degreesOf(const Movements& movements);

/// The state when `part` (0 to 1) of movements that follow each other is done; they share the time
/// by the degrees they turn. Requires one or more.
FoldedState stateAlong(const Movements& movements, double part);

/// The movement along a path from `start` to the poses of `end`, which has the same pattern. For
/// each piece a facet is held that lies in both as it did, where there is one.
Movement movementAlong(const FoldedState& start, std::shared_ptr<const RigidPath> path,
                       const FoldedState& end);

}  // namespace kiri
