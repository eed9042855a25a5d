// The model that a command works on, and the state that was asked for.
// SPDX-License-Identifier: MIT
#include "apps/cli/model_input.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <utility>

#include "apps/cli/pattern_import.h"
#include "core/base/text.h"
#include "core/model/timeline.h"
#include "io/kiri_reader.h"
#include "io/steps_json.h"

namespace kiri::cli {

Result<ModelInput> modelFrom(Console& console, const InputText& text) {
  ModelInput input;
  input.name = text.name;
  input.folder = text.folder;
  Result<LoadedModel> loaded = readKiri(text.text, input.name);
  if (!loaded.isOk()) return loaded.error();
  for (const std::string& warning : loaded->warnings) warn(console, warning);
  input.model = std::move(loaded->model);
  return input;
}

Result<ModelInput> loadModel(Console& console, const std::string& path) {
  const Result<InputText> text = readInput(console, path);
  if (!text.isOk()) return text.error();
  return isPattern(*text) ? modelFromPattern(console, *text) : modelFrom(console, *text);
}

namespace {

/// Without the "step 3: " that the time line puts before what is wrong with a step.
Error withoutStep(Error error) {
  const std::size_t colon = error.message.find(": ");
  if (error.message.rfind("step ", 0) == 0 && colon != std::string::npos) {
    error.message.erase(0, colon + 2);
  }
  return error;
}

}  // namespace

void addStepOption(CLI::App& command, std::optional<double>& step) {
  command
      .add_option(
          "--step", step,
          "after this many steps; 0: the sheet, 2.5: half way through the third (default: all)")
      ->type_name("N");
}

Result<StepChoice> chooseStep(const ModelInput& input, const std::optional<double>& step) {
  const std::size_t count = input.model.steps.size();
  if (!step) return StepChoice{count};
  if (!(*step >= 0 && *step <= static_cast<double>(count))) {
    return Error{ErrorCode::BadValue,
                 "there is no step " + text(*step) + ": " + input.name + " has " +
                     std::to_string(count) + (count == 1 ? " step" : " steps") +
                     ", so --step takes 0 (the sheet) to " + std::to_string(count)};
  }
  const double done = std::floor(*step);
  return StepChoice{static_cast<std::size_t>(done), *step - done};
}

Result<Replay> replayFirst(Console& console, const ModelInput& input, std::size_t count) {
  Model model = input.model;
  model.steps.resize(count);
  ProgressLine line(console, "folding");
  Result<Replay> result = replay(model, line.progress());
  if (!result.isOk() && result.error().code != ErrorCode::Cancelled) {
    Error error = result.error();
    error.message = input.name + ": sheet: " + error.message;
    return error;
  }
  return result;
}

Error errorOfStep(const ModelInput& input, std::size_t index, const Error& error) {
  Error out = error;
  out.message =
      input.name + ": " + describeStep(input.model.steps[index], index + 1) + ": " + error.message;
  return out;
}

void warnOfCollisions(Console& console, const ModelInput& input, const FoldedState& state) {
  for (const Collision& collision : state.collisions) {
    std::string where = input.name + ": ";
    if (collision.step >= 1 && collision.step <= input.model.steps.size()) {
      where += describeStep(input.model.steps[collision.step - 1], collision.step) + ": ";
    }
    warn(console, where + collision.message);
  }
}

Result<std::shared_ptr<const FoldedState>> stateAfter(Console& console, const ModelInput& input,
                                                      const Replay& replay, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (replay.outcomes[i].error) return errorOfStep(input, i, *replay.outcomes[i].error);
  }
  Result<std::shared_ptr<const FoldedState>> state = replay.after(count);
  if (!state.isOk()) return state;
  warnOfCollisions(console, input, **state);
  return state;
}

Result<std::shared_ptr<const FoldedState>> stateAt(Console& console, const ModelInput& input,
                                                   const Replay& replay, const StepChoice& moment) {
  auto state = stateAfter(console, input, replay, moment.done);
  if (!state.isOk() || moment.part == 0) return state;
  Model under = input.model;
  under.steps.resize(moment.done + 1);
  ProgressLine line(console, "folding");
  Result<FoldedState> between = stateBetween(under, moment.number(), line.progress());
  if (!between.isOk() && between.error().code == ErrorCode::Cancelled) return between.error();
  if (!between.isOk()) return errorOfStep(input, moment.done, withoutStep(between.error()));
  return std::make_shared<const FoldedState>(std::move(*between));
}

Result<std::shared_ptr<const FoldedState>> loadState(Console& console, const ModelInput& input,
                                                     const StepChoice& moment) {
  const Result<Replay> replay = replayFirst(console, input, moment.done);
  if (!replay.isOk()) return replay.error();
  return stateAt(console, input, *replay, moment);
}

std::string titleOf(const ModelInput& input) {
  if (!input.model.title.empty()) return input.model.title;
  if (input.name == "standard input") return "";
  std::string name = input.name.substr(input.folder.size());
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace kiri::cli
