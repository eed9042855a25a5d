// A fold line that is held in closed loops of creases: the others of the loops follow it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "core/linkage/rigid_path.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// Where a fold line gets when the creases that form closed loops with it are free to follow.
struct Followed {
  std::shared_ptr<const RigidPath> path;
  FoldedState state;  ///< at the end of the path
  double amount = 0;  ///< of the line then, degrees in its own direction
};

/// Moves the line towards `amount`, and with it the hinges of fold lines that its vertices inside
/// the paper join to it, and theirs, facets staying rigid. None when nothing can move. Source:
/// rigid folding by projection, see rigidPath.
std::optional<Followed> follow(const FoldedState& state, FoldLineId line, double amount);

}  // namespace kiri
