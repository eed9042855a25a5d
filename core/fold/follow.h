// A fold line that is held in closed loops of creases: the others of the loops follow it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "core/linkage/rigid_path.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// How far a fold line gets when the creases that form closed loops with it are free to follow.
struct Followed {
  std::shared_ptr<const RigidPath> path;
  double amount = 0;  ///< of the line at the end of the path, degrees in its own direction
};

/// The way of the line towards `amount`, and with it of the hinges of fold lines that its vertices
/// inside the paper join to it, and theirs, facets staying rigid. None when nothing can move.
/// Source: rigid folding by projection, see rigidPath.
std::optional<Followed> follow(const FoldedState& state, FoldLineId line, double amount);

/// The state at the end of that way, with the collisions that are met on it.
FoldedState stateFollowing(const FoldedState& state, FoldLineId line, const Followed& followed);

}  // namespace kiri
