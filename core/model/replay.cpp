// SPDX-License-Identifier: MIT
#include "core/model/replay.h"

#include "core/model/apply.h"

namespace kiri {
namespace {

using StatePtr = std::shared_ptr<const FoldedState>;

/// Replays steps from `from` on into `replay`, whose outcomes before that are kept.
Status continueReplay(Replay& replay, const Model& model, std::size_t from,
                      const Progress& progress) {
  replay.outcomes.resize(from);
  StatePtr state = from == 0 ? replay.start : replay.outcomes[from - 1].state;
  for (std::size_t i = from; i < model.steps.size(); ++i) {
    if (!goesOn(progress, static_cast<double>(i) / static_cast<double>(model.steps.size()))) {
      return Error{
          ErrorCode::Cancelled, "the replay was stopped at step " + std::to_string(i + 1), {}};
    }
    StepOutcome outcome;
    if (state == nullptr) {
      outcome.error =
          Error{ErrorCode::NotFound,
                "this step waits for an earlier one that does not apply; mend that one first",
                {}};
    } else {
      Result<FoldedState> next = apply(*state, model.steps[i], static_cast<int>(i) + 1);
      if (next) {
        outcome.state = std::make_shared<const FoldedState>(std::move(*next));
      } else {
        outcome.error = next.error();
      }
    }
    state = outcome.state;
    replay.outcomes.push_back(std::move(outcome));
  }
  return std::monostate{};
}

}  // namespace

Result<StatePtr> Replay::after(std::size_t count) const {
  if (count == 0) return start;
  KIRI_CHECK(count <= outcomes.size(), "a state is asked for that the model has");
  for (std::size_t i = 0; i < count; ++i) {
    if (outcomes[i].state) continue;
    Error error = *outcomes[i].error;
    error.message = "step " + std::to_string(i + 1) + ": " + error.message;
    return error;
  }
  return outcomes[count - 1].state;
}

Result<Replay> replay(const Model& model, const Progress& progress) {
  const Result<Sheet> sheet = makeSheet(model.sheet);
  if (!sheet) return sheet.error();
  Replay result;
  result.start = std::make_shared<const FoldedState>(flatState(*sheet));
  const Status done = continueReplay(result, model, 0, progress);
  if (!done) return done.error();
  return result;
}

Result<History> History::open(Model model) {
  Result<Replay> replayed = replay(model);
  if (!replayed) return replayed.error();
  History history;
  history.model_ = std::move(model);
  history.replay_ = std::move(*replayed);
  history.cursor_ = history.model_.steps.size();
  return history;
}

const FoldedState& History::state() const {
  for (std::size_t i = cursor_; i > 0; --i) {
    if (replay_.outcomes[i - 1].state) return *replay_.outcomes[i - 1].state;
  }
  return *replay_.start;
}

std::optional<Error> History::problemOf(std::size_t index) const {
  return replay_.outcomes[index].error;
}

Status History::add(Step step) {
  const Result<StatePtr> before = replay_.after(cursor_);
  if (!before) return before.error();
  Result<FoldedState> next = apply(**before, step, static_cast<int>(cursor_) + 1);
  if (!next) return next.error();
  model_.steps.resize(cursor_);
  replay_.outcomes.resize(cursor_);
  model_.steps.push_back(std::move(step));
  replay_.outcomes.push_back({std::make_shared<const FoldedState>(std::move(*next)), std::nullopt});
  ++cursor_;
  return std::monostate{};
}

bool History::undo() {
  if (cursor_ == 0) return false;
  --cursor_;
  return true;
}

bool History::redo() {
  if (cursor_ == model_.steps.size()) return false;
  ++cursor_;
  return true;
}

Status History::edit(std::size_t index, Step step) {
  if (index >= model_.steps.size()) {
    return Error{
        ErrorCode::NotFound, "there is no step " + std::to_string(index + 1) + " to edit", {}};
  }
  model_.steps[index] = std::move(step);
  return continueReplay(replay_, model_, index, {});
}

Status History::remove(std::size_t index) {
  if (index >= model_.steps.size()) {
    return Error{
        ErrorCode::NotFound, "there is no step " + std::to_string(index + 1) + " to remove", {}};
  }
  model_.steps.erase(model_.steps.begin() + static_cast<std::ptrdiff_t>(index));
  if (cursor_ > index) --cursor_;
  return continueReplay(replay_, model_, index, {});
}

}  // namespace kiri
