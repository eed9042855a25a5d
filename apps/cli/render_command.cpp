// kiri render: a picture of the model after a step.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/model_input.h"
#include "apps/cli/picture_options.h"
#include "apps/cli/view_options.h"
#include "render/scene/model_scene.h"
#include "render/scene/pattern_scene.h"

namespace kiri::cli {

namespace {

constexpr const char* kPattern = "pattern";

struct RenderOptions {
  std::string model;
  std::optional<double> step;
  ViewOptions view;
  double margin = 5;
  double scale = 1;
  double grid = 0;
  bool isLinesOnly = false;
  PictureOptions picture;
};

bool showsPattern(const RenderOptions& options) { return options.view.view == kPattern; }

Status check(const RenderOptions& options) {
  constexpr double kWidest = 1000;
  if (!(options.margin >= 0 && options.margin <= kWidest)) {
    return Error{ErrorCode::BadValue, "--margin must lie between 0 and 1000 mm"};
  }
  constexpr double kMost = 1000;
  if (!(options.scale > 0 && options.scale <= kMost)) {
    return Error{ErrorCode::BadValue, "--scale must be above 0 and at most 1000"};
  }
  if (!(options.grid >= 0 && options.grid <= kWidest)) {
    return Error{ErrorCode::BadValue, "--grid must lie between 0 (none) and 1000 mm"};
  }
  if (options.isLinesOnly && !showsPattern(options)) {
    return Error{ErrorCode::BadValue, "--lines-only goes with --view pattern"};
  }
  if (showsPattern(options)) {
    if (!asksForSpace(options.view)) return std::monostate{};
    return Error{ErrorCode::BadValue,
                 "--perspective, --explode, --thickness, --shade and --shadow go with views of the "
                 "folded model, not with --view pattern"};
  }
  const Result<ViewSpec> spec = viewSpecOf(options.view, kPattern);
  if (!spec.isOk()) return spec.error();
  return std::monostate{};
}

Result<Scene> sceneOf(const FoldedState& state, const Appearance& appearance,
                      const ModelInput& input, const RenderOptions& options,
                      const Progress& progress) {
  if (showsPattern(options)) {
    return patternScene(state, appearance,
                        {options.margin, options.scale, titleOf(input),
                         options.isLinesOnly ? PatternFill::None : PatternFill::Paper});
  }
  const Result<ViewSpec> spec = viewSpecOf(options.view, kPattern);
  if (!spec.isOk()) return spec.error();
  return modelScene(state, appearance, *spec,
                    {options.margin, options.scale, titleOf(input), {}, {}, progress});
}

int run(Console& console, const RenderOptions& options) {
  const Status usage = check(options);
  if (!usage.isOk()) return fail(console, usage.error(), kBadUsage);
  const Result<std::string> format = checkPictureOptions(options.picture);
  if (!format.isOk()) return fail(console, format.error(), kBadUsage);
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  const Result<StepChoice> moment = chooseStep(*input, options.step);
  if (!moment.isOk()) return fail(console, moment.error(), kBadUsage);
  const auto state = loadState(console, *input, *moment);
  if (!state.isOk()) return fail(console, state.error());
  Result<Appearance> appearance = appearanceFor(console, *input, options.picture);
  if (!appearance.isOk()) return fail(console, appearance.error());
  appearance->gridSpacing = options.grid;
  const auto draw = [&] {
    ProgressLine line(console, "drawing");
    line.update(0);
    return sceneOf(**state, *appearance, *input, options, line.progress());
  };
  Result<Scene> scene = draw();
  if (!scene.isOk()) return fail(console, scene.error(), kBadUsage);
  return writePicture(console, std::move(*scene), options.picture, *format);
}

}  // namespace

void addRenderCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command = app.add_subcommand("render", "Draw the model after a step, in true size");
  const auto options = std::make_shared<RenderOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  addStepOption(*command, options->step);
  addViewOptions(*command, options->view, kPattern);
  command->add_option("--margin", options->margin, "mm around the model (default 5)")
      ->type_name("MM");
  command->add_option("--scale", options->scale, "1 is true size (default)")->type_name("F");
  command->add_option("--grid", options->grid, "mm between the lines of a grid behind the paper")
      ->type_name("MM");
  command->add_flag("--lines-only", options->isLinesOnly,
                    "pattern without the paper, for machines");
  addPictureOptions(*command, options->picture);
  command->footer(
      "Examples:\n"
      "  kiri render leaf.kiri -o leaf.png\n"
      "  kiri render leaf.kiri --step 3 --view back -o step3.svg\n"
      "  kiri render leaf.kiri --step 3 --view 30,40 -o step3.png\n"
      "  kiri render leaf.kiri --view pattern --style diagram -o pattern.pdf\n"
      "  cat leaf.kiri | kiri render - --format png --dpi 300 -o - > leaf.png");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
