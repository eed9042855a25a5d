// The model that a command works on, and the state that was asked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/input_text.h"
#include "core/model/model.h"
#include "core/model/replay.h"
#include "core/paper/folded_state.h"

namespace CLI {
class App;
}

namespace kiri::cli {

struct ModelInput {
  std::string name;    ///< for sentences: the path, or "standard input"
  std::string folder;  ///< textures are found relative to it
  Model model;
};

/// Reads MODEL ("-": standard input) and prints what looks odd in it. A crease pattern becomes a
/// model as kiri convert makes one.
Result<ModelInput> loadModel(Console& console, const std::string& path);
/// The same of a .kiri text that was read already.
Result<ModelInput> modelFrom(Console& console, const InputText& text);

/// A moment of the model's life: so many steps are done, and a part of the next.
struct StepChoice {
  std::size_t done = 0;
  double part = 0;  ///< 0 to below 1

  double number() const { return static_cast<double>(done) + part; }
};

/// Adds --step.
void addStepOption(CLI::App& command, std::optional<double>& step);

/// The moment that --step means: 2.5 is half way through the third step. The end by default.
/// Errors: BadValue - there are not that many steps.
Result<StepChoice> chooseStep(const ModelInput& input, const std::optional<double>& step);

/// Replays the first `count` steps, with progress. Steps that fail are marked in the result.
Result<Replay> replayFirst(Console& console, const ModelInput& input, std::size_t count);

/// "leaf.kiri: step 3 (fold "mid-vein"): what is wrong", for step `index` counted from 0.
Error errorOfStep(const ModelInput& input, std::size_t index, const Error& error);

/// Prints what pushed through what on the way to a state.
void warnOfCollisions(Console& console, const ModelInput& input, const FoldedState& state);

/// The state after `count` steps; the error names file and step. Collisions on the way are printed
/// as warnings.
Result<std::shared_ptr<const FoldedState>> stateAfter(Console& console, const ModelInput& input,
                                                      const Replay& replay, std::size_t count);

/// The same for any moment; `replay` holds the steps that are done by then.
Result<std::shared_ptr<const FoldedState>> stateAt(Console& console, const ModelInput& input,
                                                   const Replay& replay, const StepChoice& moment);

/// The state at a moment, replayed with progress.
Result<std::shared_ptr<const FoldedState>> loadState(Console& console, const ModelInput& input,
                                                     const StepChoice& moment);

/// Title of the model, or the name of its file without folder and ending.
std::string titleOf(const ModelInput& input);

}  // namespace kiri::cli
