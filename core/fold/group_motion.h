// Several fold lines at once: unfolding and refolding (thesis 4.5 B17).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/fold/movement.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// How a group of fold lines moves.
enum class GroupMotion {
  InOrder,      ///< one by one; the first that cannot move is an error, but when all that is folded
                ///< opens: then those that are left open at once
  InFreeOrder,  ///< the same, but a line that is not free to open waits for those that are: what
                ///< was closed over other folds again opens before them
  Together  ///< at once, as leaves open. How they come to lie is that of turning them one by one in
            ///< an order that works, free of collision before colliding; where creases form closed
            ///< loops that no such order opens, that of the motion itself
};

/// Folds the lines (in this order) to 0, or to the amounts they were last folded to. All of them to
/// 0 always succeeds: flat paper is flat. Errors: those of setAmount, with the remark that they can
/// move together where that is so; Cancelled. `record` gets the movements; none where the paper
/// would have to bend on the way. `progress` is asked before each line that is tried.
Result<FoldedState> unfoldLines(const FoldedState& state, std::vector<FoldLineId> lines,
                                GroupMotion motion, Movements* record = nullptr,
                                const Progress& progress = {});
Result<FoldedState> refoldLines(const FoldedState& state, const std::vector<FoldLineId>& lines,
                                GroupMotion motion, Movements* record = nullptr,
                                const Progress& progress = {});

/// Unfolds the lines one after the other, each about its own axis, in an order that works, free of
/// collision before colliding. Errors: NothingToDo, Locked - those of the first line that cannot
/// move when none can; Cancelled.
Result<FoldedState> unfoldOneByOne(const FoldedState& state, std::vector<FoldLineId> lines,
                                   Movements* record = nullptr, const Progress& progress = {});

}  // namespace kiri
