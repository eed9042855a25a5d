// The model that a command works on, and the state that was asked for.
// SPDX-License-Identifier: MIT
#include "apps/cli/model_input.h"

#include <utility>

#include "io/file.h"
#include "io/kiri_reader.h"
#include "io/steps_json.h"

namespace kiri::cli {

Result<ModelInput> loadModel(Console& console, const std::string& path) {
  const bool isStream = path == "-";
  ModelInput input;
  input.name = isStream ? "standard input" : path;
  const std::size_t slash = path.rfind('/');
  input.folder = isStream || slash == std::string::npos ? "" : path.substr(0, slash + 1);
  const Result<std::string> text = isStream ? readStream(console.in, input.name) : readFile(path);
  if (!text.isOk()) return text.error();
  Result<LoadedModel> loaded = readKiri(*text, input.name);
  if (!loaded.isOk()) return loaded.error();
  for (const std::string& warning : loaded->warnings) warn(console, warning);
  input.model = std::move(loaded->model);
  return input;
}

Result<std::size_t> chooseStep(const ModelInput& input, const std::optional<int>& step) {
  const std::size_t count = input.model.steps.size();
  if (!step) return count;
  if (*step < 0 || static_cast<std::size_t>(*step) > count) {
    return Error{ErrorCode::BadValue,
                 "there is no step " + std::to_string(*step) + ": " + input.name + " has " +
                     std::to_string(count) + (count == 1 ? " step" : " steps") +
                     ", so --step takes 0 (the sheet) to " + std::to_string(count)};
  }
  return static_cast<std::size_t>(*step);
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

Result<std::shared_ptr<const FoldedState>> stateAfter(Console& console, const ModelInput& input,
                                                      const Replay& replay, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (replay.outcomes[i].error) return errorOfStep(input, i, *replay.outcomes[i].error);
  }
  Result<std::shared_ptr<const FoldedState>> state = replay.after(count);
  if (!state.isOk()) return state;
  for (const Collision& collision : (*state)->collisions) {
    std::string where = input.name + ": ";
    if (collision.step >= 1 && collision.step <= input.model.steps.size()) {
      where += describeStep(input.model.steps[collision.step - 1], collision.step) + ": ";
    }
    warn(console, where + collision.message);
  }
  return state;
}

Result<std::shared_ptr<const FoldedState>> loadState(Console& console, const ModelInput& input,
                                                     const std::optional<int>& step) {
  const Result<std::size_t> count = chooseStep(input, step);
  if (!count.isOk()) return count.error();
  const Result<Replay> replay = replayFirst(console, input, *count);
  if (!replay.isOk()) return replay.error();
  return stateAfter(console, input, *replay, *count);
}

std::string titleOf(const ModelInput& input) {
  if (!input.model.title.empty()) return input.model.title;
  if (input.name == "standard input") return "";
  std::string name = input.name.substr(input.folder.size());
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace kiri::cli
