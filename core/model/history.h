// The history of a model: its steps with a cursor, which undo and redo walk along.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/replay.h"

namespace kiri {

/// What another history has where it differs from this one: small when they are alike, for it
/// leaves out the steps at the start that are the same. Outcomes share their states.
struct HistoryDifference {
  std::size_t first = 0;  ///< steps before this are the same
  std::vector<Step> steps;
  std::vector<StepOutcome> outcomes;  ///< one for each step, or none: forgotten to save memory
  std::optional<Model> head;          ///< all of the model but its steps, where that differs
  std::shared_ptr<const FoldedState> start;
  std::size_t count = 0;
  std::size_t cursor = 0;
};

/// A model whose last steps may have been undone, and which is looked at after any of its steps.
/// States are remembered. Value semantics; copies share states.
class History {
 public:
  /// Errors: BadValue - the sheet is no sheet; Cancelled.
  static Result<History> open(Model model, const Progress& progress = {});

  /// With the steps that were undone.
  const Model& model() const { return model_; }
  /// Steps that count: 0 to model().steps.size(). Those after them were undone; they can be redone
  /// until something is changed.
  std::size_t count() const { return count_; }
  /// Steps that are shown as done: 0 to count().
  std::size_t cursor() const { return cursor_; }
  /// The state at the cursor; when a step before it does not apply, the last state that does.
  const FoldedState& state() const { return *sharedState(); }
  std::shared_ptr<const FoldedState> sharedState() const;
  /// The state after `count` steps; none when one of them does not apply.
  std::shared_ptr<const FoldedState> stateAfter(std::size_t count) const;
  /// Why step `index` (from 0) does not apply; none when it does.
  std::optional<Error> problemOf(std::size_t index) const;

  /// Takes the last step out of force, or back in, and shows the end.
  bool undo();
  bool redo();
  /// Shows the model after `cursor` steps. Steps that were undone are redone up to there. False
  /// when there are not so many, or nothing changes.
  bool moveTo(std::size_t cursor);

  // What follows drops the steps that were undone. On an error nothing changes.

  /// Applies a new step at the cursor; it becomes the last one. Errors: those of apply.
  Status add(Step step);
  /// Puts `step` in the place of step `index` and replays what follows; steps that no longer apply
  /// are kept and marked. A fold line that gets another name is called by it in later steps too.
  /// Errors: NotFound - no such step; BadValue - numbers that no file can hold, or the name of
  /// another fold line; Cancelled.
  Status edit(std::size_t index, Step step, const Progress& progress = {});
  /// Folds after it that had no name of their own keep the one that came from their number.
  /// Errors: NotFound; Cancelled.
  Status remove(std::size_t index, const Progress& progress = {});
  /// Replays all steps. Errors: BadValue - no sheet; Cancelled.
  Status setSheet(SheetSpec sheet, const Progress& progress = {});
  void setSides(PaperSide front, PaperSide back);
  void setTitle(std::string title, std::string notes);
  void setOpening(Sequence opening);
  void dropUndone();

  /// What `other` has that this has not.
  HistoryDifference differenceTo(const History& other) const;
  /// Becomes the other history; returns the way back. Outcomes that were forgotten are replayed.
  HistoryDifference exchange(HistoryDifference difference);

 private:
  Status replayFrom(std::size_t from, const Progress& progress);

  Model model_;
  Replay replay_;
  std::size_t count_ = 0;
  std::size_t cursor_ = 0;
};

}  // namespace kiri
