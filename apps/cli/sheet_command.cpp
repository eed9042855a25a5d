// kiri sheet: the steps side by side on one page.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/model_input.h"
#include "apps/cli/number_list.h"
#include "apps/cli/picture_options.h"
#include "apps/cli/view_options.h"
#include "render/scene/sheet_scene.h"

namespace kiri::cli {

namespace {

struct SheetOptions {
  std::string model;
  std::string steps;
  ViewOptions view;
  int columns = 0;
  double width = 210;
  std::optional<double> panel;
  bool hidesNumbers = false;
  bool hidesTitles = false;
  PictureOptions picture;
};

Status check(const SheetOptions& options) {
  const Result<ViewSpec> spec = viewSpecOf(options.view);
  if (!spec.isOk()) return spec.error();
  constexpr int kMostColumns = 100;
  if (options.columns < 0 || options.columns > kMostColumns) {
    return Error{ErrorCode::BadValue, "--columns must lie between 0 (as fits) and 100"};
  }
  constexpr double kNarrowest = 20;
  constexpr double kWidest = 5000;
  if (!(options.width >= kNarrowest && options.width <= kWidest)) {
    return Error{ErrorCode::BadValue, "--width must lie between 20 and 5000 mm"};
  }
  if (options.panel && !(*options.panel > 0 && *options.panel <= kWidest)) {
    return Error{ErrorCode::BadValue, "--panel must be above 0 and at most 5000 mm"};
  }
  return std::monostate{};
}

/// Prints warnings for what happened up to the last panel. Errors: the step that does not apply.
Status lookAtSteps(Console& console, const ModelInput& input, const Replay& replay,
                   std::size_t last) {
  const auto state = stateAfter(console, input, replay, last);
  if (!state.isOk()) return state.error();
  return std::monostate{};
}

int run(Console& console, const SheetOptions& options) {
  const Status usage = check(options);
  if (!usage.isOk()) return fail(console, usage.error(), kBadUsage);
  const Result<std::string> format = checkPictureOptions(options.picture);
  if (!format.isOk()) return fail(console, format.error(), kBadUsage);
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  SheetSceneOptions scene;
  scene.columns = options.columns;
  scene.pageWidth = options.width;
  scene.panel = options.panel;
  scene.showNumbers = !options.hidesNumbers;
  scene.showTitles = !options.hidesTitles;
  const Result<ViewSpec> spec = viewSpecOf(options.view);
  if (!spec.isOk()) return fail(console, spec.error(), kBadUsage);
  scene.view = viewFrom(spec->azimuth, spec->elevation);
  std::size_t last = input->model.steps.size();
  if (!options.steps.empty()) {
    const auto panels = parseNumberList(options.steps, last + 1);
    if (!panels.isOk()) return fail(console, kBadUsage, "--steps: " + panels.error().message);
    last = 0;
    for (const std::size_t panel : *panels) {
      // Panel n shows the paper before step n; the one after all steps has the next number.
      scene.states.push_back(panel - 1);
      last = std::max(last, panel - 1);
    }
  }
  const Result<Replay> replay = replayFirst(console, *input, last);
  if (!replay.isOk()) return fail(console, replay.error());
  const Status status = lookAtSteps(console, *input, *replay, last);
  if (!status.isOk()) return fail(console, status.error());
  Result<Appearance> appearance = appearanceFor(console, *input, options.picture);
  if (!appearance.isOk()) return fail(console, appearance.error());
  appearance->isShaded = spec->isShaded;
  const auto draw = [&] {
    ProgressLine line(console, "drawing");
    line.update(0);
    return sheetScene(input->model, *replay, *appearance, scene);
  };
  Result<Scene> page = draw();
  if (!page.isOk()) return fail(console, page.error(), kBadUsage);
  return writePicture(console, std::move(*page), options.picture, *format);
}

}  // namespace

void addSheetCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("sheet", "Draw the steps side by side, the next line in each");
  const auto options = std::make_shared<SheetOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  command
      ->add_option("--steps", options->steps,
                   "which panels, by their numbers, like first,3-5,last (default: all)")
      ->type_name("LIST");
  addViewOption(*command, options->view);
  command->add_flag("--shade", options->view.isShaded, "facets turned away look darker");
  command->add_option("--columns", options->columns, "panels in a row (default: as fits)")
      ->type_name("N");
  command->add_option("--width", options->width, "mm of the page (default 210)")->type_name("MM");
  command->add_option("--panel", options->panel, "side of a panel in mm (default: as fits)")
      ->type_name("MM");
  command->add_flag("--no-numbers", options->hidesNumbers, "leave out the numbers of the steps");
  command->add_flag("--no-titles", options->hidesTitles, "leave out the titles of the steps");
  addPictureOptions(*command, options->picture);
  command->footer(
      "Examples:\n"
      "  kiri sheet leaf.kiri -o leaf.pdf\n"
      "  kiri sheet leaf.kiri --steps first,4-7,last --columns 3 -o leaf.svg\n"
      "  kiri sheet leaf.kiri --style diagram --background \"#ffffff\" -o leaf.png");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
