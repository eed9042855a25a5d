// kiri info: the figures of a state, for people and for programs.
// SPDX-License-Identifier: MIT
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/json_parts.h"
#include "apps/cli/model_input.h"
#include "apps/cli/state_facts.h"

namespace kiri::cli {

namespace {

struct InfoOptions {
  std::string model;
  std::optional<double> step;
  bool isJson = false;
};

const char* nameOf(CollisionMoment moment) {
  switch (moment) {
    case CollisionMoment::Start:
      return "start";
    case CollisionMoment::End:
      return "end";
    case CollisionMoment::Hinge:
      return "hinge";
    case CollisionMoment::During:
      return "during";
  }
  return "";
}

JsonValue number(double value) { return JsonValue::ofNumber(value); }

JsonValue collisionsOf(const FoldedState& state) {
  JsonValue out = JsonValue::array();
  for (const Collision& collision : state.collisions) {
    JsonValue& item = out.items.emplace_back(JsonValue::object());
    item.add("step", number(collision.step));
    item.add("moment", JsonValue::ofText(nameOf(collision.moment)));
    item.add("moving", pointJson(collision.moving));
    item.add("fixed", pointJson(collision.fixed));
    item.add("degrees", number(collision.degrees));
    item.add("place", pointJson(collision.place));
    item.add("certain", JsonValue::ofBool(collision.isCertain));
    item.add("message", JsonValue::ofText(collision.message));
  }
  return out;
}

JsonValue foldLinesOf(const StateFacts& facts) {
  JsonValue out = JsonValue::array();
  for (const FoldLineFacts& line : facts.lines) {
    JsonValue& item = out.items.emplace_back(JsonValue::object());
    item.add("name", JsonValue::ofText(line.name));
    item.add("type", JsonValue::ofText(line.isValley ? "valley" : "mountain"));
    item.add("angle", line.angle ? number(*line.angle) : JsonValue{});
    item.add("hinges", countJson(line.hinges));
  }
  return out;
}

template <class Point>
JsonValue boxOf(Point low, Point high) {
  JsonValue out = JsonValue::object();
  out.add("low", pointJson(low));
  out.add("high", pointJson(high));
  return out;
}

std::string jsonOf(const ModelInput& input, const StepChoice& step, const FoldedState& state,
                   const StateFacts& facts) {
  JsonValue out = JsonValue::object();
  out.add("file", JsonValue::ofText(input.name));
  out.add("title", JsonValue::ofText(titleOf(input)));
  out.add("steps", countJson(input.model.steps.size()));
  out.add("step", number(step.number()));
  out.add("facets", countJson(facts.facets));
  out.add("hinges", countJson(facts.hinges));
  out.add("fold_lines", countJson(facts.lines.size()));
  out.add("torn_edges", countJson(facts.tornEdges));
  out.add("pieces", countJson(facts.pieces));
  out.add("area_mm2", number(facts.area));
  out.add("flat", JsonValue::ofBool(facts.isFlat));
  out.add("layers", number(facts.layers));
  out.add("stretch_mm", number(facts.stretch));
  out.add("collisions", collisionsOf(state));
  out.add("fold_line_list", foldLinesOf(facts));
  out.add("paper_box_mm", boxOf(facts.paper.low, facts.paper.high));
  out.add("model_box_mm", boxOf(facts.boxLow, facts.boxHigh));
  constexpr std::size_t kDocument = 1;
  return layOut(out, kDocument);
}

std::string shown(double value) {
  std::ostringstream out;
  out << std::setprecision(6) << (value == 0 ? 0.0 : value);  // no "-0"
  return out.str();
}

std::string tableOf(const ModelInput& input, const StepChoice& step, const FoldedState& state,
                    const StateFacts& facts) {
  std::ostringstream out;
  const auto row = [&](const char* name, const std::string& value) {
    constexpr int kColumn = 12;
    out << std::left << std::setw(kColumn) << name << value << '\n';
  };
  const Vec2 paper = facts.paper.high - facts.paper.low;
  const Vec3 model = facts.boxHigh - facts.boxLow;
  row("title", titleOf(input));
  row("step", shown(step.number()) + " of " + std::to_string(input.model.steps.size()));
  row("facets", std::to_string(facts.facets));
  row("hinges",
      std::to_string(facts.hinges) +
          (facts.tornEdges > 0 ? ", torn edges: " + std::to_string(facts.tornEdges) : ""));
  row("pieces", std::to_string(facts.pieces));
  row("area", shown(facts.area) + " mm^2");
  row("flat", facts.isFlat ? "yes" : "no");
  row("layers", std::to_string(facts.layers));
  row("stretch", shown(facts.stretch) + " mm");
  row("paper", shown(paper.x) + " x " + shown(paper.y) + " mm");
  row("model", shown(model.x) + " x " + shown(model.y) + " x " + shown(model.z) + " mm");
  row("collisions", std::to_string(state.collisions.size()));
  row("fold lines", std::to_string(facts.lines.size()));
  for (const FoldLineFacts& line : facts.lines) {
    row("", line.name + ": " + (line.isValley ? "valley" : "mountain") + ", " +
                (line.angle ? "at " + shown(*line.angle) + " degrees" : "at several angles") +
                ", hinges: " + std::to_string(line.hinges));
  }
  return out.str();
}

int run(Console& console, const InfoOptions& options) {
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  const Result<StepChoice> step = chooseStep(*input, options.step);
  if (!step.isOk()) return fail(console, step.error(), kBadUsage);
  const auto state = loadState(console, *input, *step);
  if (!state.isOk()) return fail(console, state.error());
  const StateFacts facts = factsOf(**state);
  return writeResult(console, "-",
                     options.isJson ? jsonOf(*input, *step, **state, facts)
                                    : tableOf(*input, *step, **state, facts));
}

}  // namespace

void addInfoCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command = app.add_subcommand("info", "Print the figures of the model after a step");
  const auto options = std::make_shared<InfoOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  addStepOption(*command, options->step);
  command->add_flag("--json", options->isJson, "one JSON object, for programs");
  command->footer(
      "Examples:\n"
      "  kiri info leaf.kiri\n"
      "  kiri info leaf.kiri --step 3 --json\n"
      "  kiri info leaf.kiri --json | python3 -c 'import json, sys; "
      "print(json.load(sys.stdin)[\"facets\"])'");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
