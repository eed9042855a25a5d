// What a collision says: which paper, at which angle, where, and what would help.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/paper/folded_state.h"
#include "core/sweep/sweep.h"

namespace kiri {

/// A motion as collisions speak of it.
struct Turned {
  const FoldedState& before;
  const FoldedState& after;
  const std::vector<bool>& moves;
  const Motion& motion;
};

/// How far the fold is folded, in its own direction, when the motion has turned by `degrees` (of
/// the sign of the motion): as its fold line counts, or the mere turn where no line drives it.
double amountAfter(const Turned& turned, double degrees);

/// What relayer and the hinges found at the ends of the motion.
Collision described(const Turned& turned, const Contact& contact);

/// What the sweep found on the way. Requires a report that is not Free.
Collision described(const Turned& turned, const SweepReport& report);

}  // namespace kiri
