// Fold lines after the fold: setting an angle again (thesis 4.1, sliders).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/fold/movement.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The hinges that a fold line drives, by number.
std::vector<EdgeId> hingesOf(const FoldedState& state, FoldLineId line);

/// The state with a fold line folded by `amount` degrees in its own direction (-180 to 180,
/// negative: the other way). The side that its fold moved moves again, with all that hangs on it.
/// Where the line's creases are held in closed loops, the other creases of these loops follow, if
/// the facets can stay rigid. Where it lies flat and other folds have turned a part of it over,
/// that part folds with the longest crease, the other way round than before, and so from now on.
/// Errors: NothingToDo - the line has no hinges left; Locked - it cannot move so far: says how far,
/// and names the fold lines that hold it. `record` gets the movement.
Result<FoldedState> setAmount(const FoldedState& state, FoldLineId line, double amount,
                              Movements* record = nullptr);

/// The same about the line's own axis only: closed loops are errors, and parts turned over.
Result<FoldedState> setAmountAlone(const FoldedState& state, FoldLineId line, double amount,
                                   Movements* record = nullptr);

/// The same with closed loops, but parts turned over are errors.
Result<FoldedState> setAmountFollowed(const FoldedState& state, FoldLineId line, double amount,
                                      Movements* record = nullptr);

/// The same about the line's own axis, with the parts of it that were turned over.
Result<FoldedState> setAmountTurnedOver(const FoldedState& state, FoldLineId line, double amount,
                                        Movements* record = nullptr);

/// How far a slider came.
struct Slide {
  FoldedState state;
  double amount = 0;         ///< degrees in the line's own direction that were reached
  std::optional<Error> why;  ///< what stopped it short of what was asked for
};

/// The same for a slider that is dragged: it goes as far as the paper lets it.
Slide slideAmount(const FoldedState& state, FoldLineId line, double amount);

}  // namespace kiri
