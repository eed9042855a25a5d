// kiri steps: the list of steps, and whether each applies.
// SPDX-License-Identifier: MIT
#include <memory>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/model_input.h"
#include "io/json_tree.h"
#include "io/steps_json.h"

namespace kiri::cli {

namespace {

struct StepsOptions {
  std::string model;
  bool isJson = false;
};

/// How many collisions step `index` (from 0) met.
std::size_t collisionsAt(const Replay& replay, std::size_t index) {
  const auto& state = replay.outcomes[index].state;
  std::size_t count = 0;
  if (state) {
    for (const Collision& collision : state->collisions)
      count += collision.step == index + 1 ? 1 : 0;
  }
  return count;
}

std::string jsonOf(const ModelInput& input, const Replay& replay) {
  JsonValue out = JsonValue::object();
  out.add("file", JsonValue::ofText(input.name));
  out.add("title", JsonValue::ofText(titleOf(input)));
  JsonValue& list = out.add("steps", JsonValue::array());
  for (std::size_t i = 0; i < input.model.steps.size(); ++i) {
    const Step& step = input.model.steps[i];
    const StepOutcome& outcome = replay.outcomes[i];
    JsonValue& item = list.items.emplace_back(JsonValue::object());
    item.add("number", JsonValue::ofNumber(static_cast<double>(i + 1)));
    item.add("do", JsonValue::ofText(kindOf(step)));
    item.add("title", JsonValue::ofText(step.title));
    item.add("applies", JsonValue::ofBool(outcome.state != nullptr));
    item.add("error", outcome.error ? JsonValue::ofText(outcome.error->message) : JsonValue{});
    item.add("facets",
             outcome.state
                 ? JsonValue::ofNumber(static_cast<double>(outcome.state->pattern.facets.size()))
                 : JsonValue{});
    item.add("collisions", JsonValue::ofNumber(static_cast<double>(collisionsAt(replay, i))));
  }
  constexpr std::size_t kDocument = 1;
  return layOut(out, kDocument);
}

std::string tableOf(const ModelInput& input, const Replay& replay) {
  std::string out = titleOf(input) + ": " + std::to_string(input.model.steps.size()) +
                    (input.model.steps.size() == 1 ? " step\n" : " steps\n");
  for (std::size_t i = 0; i < input.model.steps.size(); ++i) {
    const StepOutcome& outcome = replay.outcomes[i];
    out +=
        "  " + describeStep(input.model.steps[i], i + 1).substr(std::string("step ").size()) + ": ";
    if (outcome.error) {
      out += "does not apply: " + outcome.error->message;
    } else {
      out += std::to_string(outcome.state->pattern.facets.size()) + " facets";
      const std::size_t collisions = collisionsAt(replay, i);
      if (collisions > 0) out += ", collisions: " + std::to_string(collisions);
    }
    out += "\n";
  }
  return out;
}

int run(Console& console, const StepsOptions& options) {
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  const Result<Replay> replay = replayFirst(console, *input, input->model.steps.size());
  if (!replay.isOk()) return fail(console, replay.error());
  const int written = writeResult(
      console, "-", options.isJson ? jsonOf(*input, *replay) : tableOf(*input, *replay));
  if (written != kDone) return written;
  for (std::size_t i = 0; i < replay->outcomes.size(); ++i) {
    if (replay->outcomes[i].error)
      return fail(console, errorOfStep(*input, i, *replay->outcomes[i].error));
  }
  return kDone;
}

}  // namespace

void addStepsCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command = app.add_subcommand("steps", "List the steps and whether each applies");
  const auto options = std::make_shared<StepsOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  command->add_flag("--json", options->isJson, "one JSON object, for programs");
  command->footer(
      "Examples:\n"
      "  kiri steps leaf.kiri\n"
      "  kiri steps leaf.kiri --json");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
