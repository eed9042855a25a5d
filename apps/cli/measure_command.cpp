// kiri measure: what botanists measure on a leaf, or any outline.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/commands.h"
#include "apps/cli/measure_report.h"
#include "apps/cli/model_input.h"
#include "apps/cli/outline_input.h"
#include "apps/cli/picture_options.h"
#include "core/leaf/leaf_measures.h"
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
  OutlineOptions outline;
  PictureOptions picture;
};

Status checkMeasureUsage(const MeasureCommandOptions& options) {
  if (options.isJson && options.isCsv) {
    return Error{ErrorCode::BadValue, "--json and --csv do not go together"};
  }
  return checkOutlineOptions(options.outline);
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

/// Where radii are measured from, and how that was found.
struct PetioleChoice {
  std::optional<Vec2> place;
  std::string from;
};

PetioleChoice petioleOf(const MeasureCommandOptions& options, const OutlineInput& outline,
                        const FoldedState& state) {
  if (!options.petiole.empty()) return {Vec2{options.petiole[0], options.petiole[1]}, "given"};
  if (outline.origin) return {outline.origin, "origin of the file"};
  if (petioleOfVeins(state.pattern)) return {std::nullopt, "where most creases meet on the margin"};
  return {std::nullopt, "middle of the area; --petiole X Y says another place"};
}

int run(Console& console, const MeasureCommandOptions& options) {
  const Status usage = checkMeasureUsage(options);
  if (!usage) return fail(console, usage.error(), kBadUsage);
  const Result<OutlineInput> outline = loadOutline(console, options.model, options.outline);
  if (!outline) return fail(console, outline.error());
  const ModelInput& input = outline->input;
  const Result<StepChoice> moment = chooseStep(input, options.step);
  if (!moment) return fail(console, moment.error(), kBadUsage);
  const auto state = loadState(console, input, *moment);
  if (!state) return fail(console, state.error());
  const PetioleChoice petiole = petioleOf(options, *outline, **state);
  const MeasureOptions wanted{petiole.place, options.axis, options.prominence};
  const Result<LeafMeasures> measures = measuresOf((*state)->pattern, wanted);
  if (!measures) {
    return fail(console, {measures.error().code, input.name + ": " + measures.error().message});
  }
  const MeasuredThing thing{input.name, petiole.from, options.prominence};
  console.out << (options.isJson  ? measuresJson(thing, *measures)
                  : options.isCsv ? measuresCsv(thing, *measures)
                                  : measuresText(thing, *measures));
  if (options.picture.out.empty()) return kDone;
  return drawMeasures(console, input, **state, *measures, options.picture);
}

}  // namespace

void addMeasureCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("measure", "Measure a leaf or any outline: size, shape, lobes, symmetry");
  const auto options = std::make_shared<MeasureCommandOptions>();
  command
      ->add_option("FILE", options->model,
                   "a .kiri file, a crease pattern, or an outline of points (.csv, .txt): x and y "
                   "in each line; - for standard input")
      ->required();
  command->add_option("--step", options->step, "after this many steps (default: all)")
      ->type_name("N");
  command->add_flag("--json", options->isJson, "for programs");
  command->add_flag("--csv", options->isCsv, "one measure a row");
  command
      ->add_option("--petiole", options->petiole,
                   "where the blade begins, mm on the paper (default: where most veins meet on the "
                   "margin; of points, their origin where it lies at the outline)")
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
  addOutlineOptions(*command, options->outline);
  addPictureOptions(*command, options->picture);
  command->get_option("--output")->required(false);
  command->footer(
      "Examples:\n"
      "  kiri measure leaf.kiri\n"
      "  kiri measure leaf.kiri --csv > leaf.csv\n"
      "  kiri measure leaf.kiri --json -o leaf-measured.png\n"
      "  kiri measure outline.csv --mm-per-unit 10 -o outline.svg");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
