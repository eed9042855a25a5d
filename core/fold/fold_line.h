// Fold lines after the fold: setting an angle again, unfolding, refolding (thesis 4.1 sliders, 4.5
// B17). SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The state with a fold line folded by `amount` degrees in its own direction (-180 to 180,
/// negative: the other way). The side that its fold moved moves again, with all that hangs on it.
/// Errors: NothingToDo - the line has no hinges left; Locked - its hinges are not in line, are
/// folded unevenly, or the paper is joined around them; names the fold lines that hold it.
Result<FoldedState> setAmount(const FoldedState& state, FoldLineId line, double amount);

/// How a group of fold lines moves.
enum class GroupMotion {
  InOrder,   ///< one by one; the first that cannot move is an error
  Together,  ///< in any order that works: free of collision before colliding, the order given as a
             ///< last resort
};

/// Folds the lines (in this order) to 0, or to the amounts they were last folded to. Together and
/// all of them to 0 always succeeds: flat paper is flat. Errors: those of setAmount.
Result<FoldedState> unfoldLines(const FoldedState& state, std::vector<FoldLineId> lines,
                                GroupMotion motion);
Result<FoldedState> refoldLines(const FoldedState& state, const std::vector<FoldLineId>& lines,
                                GroupMotion motion);

}  // namespace kiri
