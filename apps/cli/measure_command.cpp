// kiri measure: what botanists measure on a leaf, or any outline.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/commands.h"
#include "apps/cli/measure_names.h"
#include "apps/cli/model_input.h"
#include "apps/cli/picture_options.h"
#include "core/base/text.h"
#include "core/leaf/leaf_measures.h"
#include "io/json_tree.h"
#include "render/scene/measure_scene.h"

namespace kiri::cli {

namespace {

struct MeasureCommandOptions {
  std::string model;
  std::optional<double> step;
  bool isJson = false;
  bool isCsv = false;
  std::vector<double> petiole;
  std::optional<double> axis;
  double prominence = MeasureOptions{}.prominence;
  PictureOptions picture;
};

const char* kindOf(const MarginPoint& point) { return point.isLobe ? "lobe" : "sinus"; }

JsonValue placeJson(Vec2 p) {
  JsonValue out = JsonValue::array();
  out.items = {JsonValue::ofNumber(p.x), JsonValue::ofNumber(p.y)};
  return out;
}

std::string measuresJson(const ModelInput& input, const LeafMeasures& m) {
  JsonValue out = JsonValue::object();
  out.add("model", JsonValue::ofText(input.name));
  out.add("conventions",
          JsonValue::ofText("length: petiole to apex; aspectRatio: length / width; circularity: 4 "
                            "pi area / perimeter^2 (ImageJ); solidity: area / hull area (ImageJ); "
                            "asymmetry: greatest distance to the mirror image; angles from the "
                            "axis, clockwise; mm, degrees"));
  out.add("petiole", placeJson(m.petiole));
  for (const NamedMeasure& measure : namedMeasures(m)) {
    out.add(measure.name, JsonValue::ofNumber(measure.value));
  }
  JsonValue margin = JsonValue::array();
  for (const MarginPoint& point : m.margin) {
    JsonValue& item = margin.items.emplace_back(JsonValue::object());
    item.add("kind", JsonValue::ofText(kindOf(point)));
    item.add("angle", JsonValue::ofNumber(point.angle));
    item.add("length", JsonValue::ofNumber(point.length));
    item.add("place", placeJson(point.place));
  }
  out.add("margin", std::move(margin));
  return layOut(out, 1);
}

/// Tidy: one measure a row.
std::string measuresCsv(const LeafMeasures& m) {
  std::string out = "measure,value,unit,angle,x,y\n";
  for (const NamedMeasure& measure : namedMeasures(m)) {
    out +=
        std::string(measure.name) + "," + numberText(measure.value) + "," + measure.unit + ",,,\n";
  }
  for (const MarginPoint& point : m.margin) {
    out += std::string(kindOf(point)) + "," + numberText(point.length) + ",mm," +
           numberText(point.angle) + "," + numberText(point.place.x) + "," +
           numberText(point.place.y) + "\n";
  }
  return out;
}

std::string measuresText(const LeafMeasures& m) {
  std::string out;
  for (const NamedMeasure& measure : namedMeasures(m)) {
    std::string name = measure.name;
    name.resize(16, ' ');
    out += name + text(measure.value) +
           (*measure.unit != 0 ? std::string(" ") + measure.unit : "") + "\n";
  }
  for (const MarginPoint& point : m.margin) {
    std::string name = kindOf(point);
    name.resize(16, ' ');
    out += name + text(point.length) + " mm at " + text(point.angle) + " degrees\n";
  }
  return out;
}

Status checkMeasureUsage(const MeasureCommandOptions& options) {
  if (options.isJson && options.isCsv) {
    return Error{ErrorCode::BadValue, "--json and --csv do not go together"};
  }
  return std::monostate{};
}

int drawMeasures(Console& console, const ModelInput& input, const FoldedState& state,
                 const LeafMeasures& measures, const PictureOptions& picture) {
  const Result<std::string> format = checkPictureOptions(picture);
  if (!format) return fail(console, format.error(), kBadUsage);
  const Result<Appearance> appearance = appearanceFor(console, input, picture);
  if (!appearance) return fail(console, appearance.error());
  PatternSceneOptions scene;
  scene.title = titleOf(input);
  return writePicture(console, measureScene(state, measures, *appearance, scene), picture, *format);
}

int run(Console& console, const MeasureCommandOptions& options) {
  const Status usage = checkMeasureUsage(options);
  if (!usage) return fail(console, usage.error(), kBadUsage);
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input) return fail(console, input.error());
  const Result<StepChoice> moment = chooseStep(*input, options.step);
  if (!moment) return fail(console, moment.error(), kBadUsage);
  const auto state = loadState(console, *input, *moment);
  if (!state) return fail(console, state.error());
  MeasureOptions wanted;
  if (!options.petiole.empty()) wanted.petiole = Vec2{options.petiole[0], options.petiole[1]};
  wanted.axis = options.axis;
  wanted.prominence = options.prominence;
  const Result<LeafMeasures> measures = measuresOf((*state)->pattern, wanted);
  if (!measures) {
    return fail(console, {measures.error().code, input->name + ": " + measures.error().message});
  }
  console.out << (options.isJson  ? measuresJson(*input, *measures)
                  : options.isCsv ? measuresCsv(*measures)
                                  : measuresText(*measures));
  if (options.picture.out.empty()) return kDone;
  return drawMeasures(console, *input, **state, *measures, options.picture);
}

}  // namespace

void addMeasureCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("measure", "Measure the outline: size, shape, lobes, symmetry");
  const auto options = std::make_shared<MeasureCommandOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  command->add_option("--step", options->step, "after this many steps (default: all)")
      ->type_name("N");
  command->add_flag("--json", options->isJson, "for programs");
  command->add_flag("--csv", options->isCsv, "one measure a row");
  command
      ->add_option("--petiole", options->petiole,
                   "where the blade begins, mm on the paper (default: where most veins meet on the "
                   "margin)")
      ->type_name("X Y")
      ->expected(2);
  command
      ->add_option("--axis", options->axis,
                   "direction of the axis, degrees from upright (default: to the farthest tip)")
      ->type_name("DEG");
  command
      ->add_option("--prominence", options->prominence,
                   "how far a lobe must stand out, as part of the longest radius (default 0.02)")
      ->type_name("F");
  addPictureOptions(*command, options->picture);
  command->get_option("--output")->required(false);
  command->footer(
      "Examples:\n"
      "  kiri measure leaf.kiri\n"
      "  kiri measure leaf.kiri --csv > leaf.csv\n"
      "  kiri measure leaf.kiri --json -o leaf-measured.png");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
