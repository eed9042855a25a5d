// Replaying a model's steps, and the history that undo and redo walk along.
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

/// A model with a cursor: undo moves the cursor back, redo forward, states are remembered. Value
/// semantics.
class History {
 public:
  /// Errors: BadValue - the sheet is no sheet.
  static Result<History> open(Model model);

  const Model& model() const { return model_; }
  /// Steps that count as done: 0 to model().steps.size().
  std::size_t cursor() const { return cursor_; }
  /// The state at the cursor; when a step before it does not apply, the last state that does.
  const FoldedState& state() const;
  /// Why step `index` (from 0) does not apply; none when it does.
  std::optional<Error> problemOf(std::size_t index) const;

  /// Applies a new step at the cursor and drops what had been undone. Errors: those of apply;
  /// nothing changes then.
  Status add(Step step);
  bool undo();
  bool redo();
  /// Puts `step` in the place of step `index` and replays what follows; steps that no longer apply
  /// are kept and marked.
  Status edit(std::size_t index, Step step);
  Status remove(std::size_t index);

 private:
  Model model_;
  Replay replay_;
  std::size_t cursor_ = 0;
};

}  // namespace kiri
