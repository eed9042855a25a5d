// Applying a model's steps one after the other.
// SPDX-License-Identifier: MIT
#include "core/model/replay.h"

#include "core/model/apply.h"

namespace kiri {

using SharedState = std::shared_ptr<const FoldedState>;

Status replayFrom(Replay& replay, const Model& model, std::size_t from, const Progress& progress) {
  replay.outcomes.resize(from);
  SharedState state = from == 0 ? replay.start : replay.outcomes[from - 1].state;
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

Result<SharedState> Replay::after(std::size_t count) const {
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
  const Status done = replayFrom(result, model, 0, progress);
  if (!done) return done.error();
  return result;
}

}  // namespace kiri
