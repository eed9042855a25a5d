// Replaying a model's steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// What came of one step.
struct StepOutcome {
  std::shared_ptr<const FoldedState> state;  ///< after the step; none when it does not apply
  std::optional<Error> error;  ///< why it does not apply; set exactly when state is none
};

/// The states of a model. A step that does not apply is kept, marked, and stops the replay; the
/// steps after it are marked as waiting for it.
struct Replay {
  std::shared_ptr<const FoldedState> start;  ///< the untouched sheet
  std::vector<StepOutcome> outcomes;         ///< one for each step

  /// The state after `count` steps (0: the sheet), or the error of the first step that does not
  /// apply.
  Result<std::shared_ptr<const FoldedState>> after(std::size_t count) const;
};

/// Errors: BadValue - the sheet is no sheet; Cancelled - progress said so. Steps that fail are
/// marked, not errors.
Result<Replay> replay(const Model& model, const Progress& progress = {});

/// Replays the steps from index `from` on; the outcomes before it are kept. On an error the replay
/// is of no use. Errors: Cancelled.
Status replayFrom(Replay& replay, const Model& model, std::size_t from,
                  const Progress& progress = {});

}  // namespace kiri
