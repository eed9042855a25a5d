// kiri export: the model in the formats of other programs.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/commands.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_format.h"
#include "io/fold_writer.h"
#include "io/obj_writer.h"
#include "io/steps_json.h"
#include "io/svg_pattern_writer.h"

namespace kiri::cli {

namespace {

struct ExportOptions {
  std::string model;
  std::string out;
  std::string format;
  std::string view;
  std::optional<int> step;
  bool isAsFolded = false;
  bool isTwoSided = false;
  double layerGap = 0;
};

Status check(const ExportOptions& options, const std::string& format) {
  if (!options.view.empty() && options.view != "folded" && options.view != "pattern") {
    return Error{ErrorCode::BadValue,
                 "--view " + options.view + " is not known; it takes folded or pattern"};
  }
  if (format == "svg" && options.view == "folded") {
    return Error{ErrorCode::BadValue,
                 "export writes SVG of the crease pattern; for the folded model use kiri render"};
  }
  if (options.isAsFolded && format == "obj") {
    return Error{ErrorCode::BadValue, "--as-folded goes with fold and svg"};
  }
  if (options.isAsFolded && format == "fold" && options.view != "pattern") {
    return Error{ErrorCode::BadValue, "--as-folded goes with --view pattern"};
  }
  if (format != "obj" && (options.isTwoSided || options.layerGap != 0)) {
    return Error{ErrorCode::BadValue, "--two-sided and --layer-gap go with obj"};
  }
  constexpr double kWidest = 100;
  if (!(options.layerGap >= 0 && options.layerGap <= kWidest)) {
    return Error{ErrorCode::BadValue, "--layer-gap must lie between 0 and 100 mm"};
  }
  return std::monostate{};
}

std::vector<FoldFrame> historyOf(const ModelInput& input, const Replay& replay, std::size_t count) {
  std::vector<FoldFrame> out;
  for (std::size_t i = 0; i < count; ++i) {
    const Step& step = input.model.steps[i];
    out.push_back({replay.outcomes[i].state,
                   step.title.empty() ? describeStep(step, i + 1) : step.title, step.notes});
  }
  return out;
}

Exported foldOf(const ModelInput& input, const Replay& replay, std::size_t count,
                const FoldedState& state, const ExportOptions& options) {
  const FoldOptions fold{"KiriSim " KIRI_VERSION, titleOf(input), input.model.notes};
  if (options.view != "pattern") return writeFold(state, historyOf(input, replay, count), fold);
  return writeFold(options.isAsFolded ? asFolded(state) : state, {}, fold);
}

Exported svgOf(const ModelInput& input, const FoldedState& state, const ExportOptions& options) {
  SvgPatternOptions svg;
  svg.title = titleOf(input);
  return {writeSvgPattern(options.isAsFolded ? asFolded(state) : state, svg), {}};
}

Exported objOf(const ModelInput& input, const FoldedState& state, const ExportOptions& options) {
  ObjOptions obj;
  obj.title = titleOf(input);
  const Result<Sheet> sheet = makeSheet(input.model.sheet);
  if (sheet.isOk()) obj.sheet = boundsOf(sheet->outline);
  obj.isTwoSided = options.isTwoSided;
  obj.layerGap = options.layerGap;
  obj.isPattern = options.view == "pattern";
  return writeObj(state, obj);
}

int run(Console& console, const ExportOptions& options) {
  const Result<std::string> format =
      chooseFormat(options.out, options.format, {"fold", "svg", "obj"});
  if (!format.isOk()) return fail(console, format.error(), kBadUsage);
  const Status usage = check(options, *format);
  if (!usage.isOk()) return fail(console, usage.error(), kBadUsage);
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  const Result<std::size_t> count = chooseStep(*input, options.step);
  if (!count.isOk()) return fail(console, count.error(), kBadUsage);
  const Result<Replay> replay = replayFirst(console, *input, *count);
  if (!replay.isOk()) return fail(console, replay.error());
  const auto state = stateAfter(console, *input, *replay, *count);
  if (!state.isOk()) return fail(console, state.error());
  if (isCancelled(console)) return fail(console, Error{ErrorCode::Cancelled, "", {}});
  Exported exported;
  {
    ProgressLine line(console, "writing");
    line.update(0);
    exported = *format == "fold"  ? foldOf(*input, *replay, *count, **state, options)
               : *format == "svg" ? svgOf(*input, **state, options)
                                  : objOf(*input, **state, options);
  }
  const int written = writeResult(console, options.out, exported.text);
  for (const std::string& loss : exported.losses) console.err << "note: " << loss << '\n';
  return written;
}

}  // namespace

void addExportCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("export", "Write the model for other programs: FOLD, SVG, OBJ");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  command->add_option("-o,--output", options->out, "file to write, - for standard output")
      ->type_name("OUT")
      ->required();
  command
      ->add_option("--format", options->format, "fold, svg or obj (default: by the ending of OUT)")
      ->type_name("FORMAT");
  command->add_option("--step", options->step, "after this many steps; 0: the sheet (default: all)")
      ->type_name("N");
  command
      ->add_option(
          "--view", options->view,
          "pattern: the crease pattern only; folded: with the folded forms (default for fold, obj)")
      ->type_name("VIEW");
  command->add_flag("--as-folded", options->isAsFolded,
                    "pattern: creases that lie flat again get the angle that their fold gave them");
  command->add_flag("--two-sided", options->isTwoSided, "obj: triangles for the back as well");
  command
      ->add_option("--layer-gap", options->layerGap,
                   "obj: mm between the layers of a plane (default 0)")
      ->type_name("MM");
  command->footer(
      "Examples:\n"
      "  kiri export leaf.kiri -o leaf.fold\n"
      "  kiri export leaf.kiri --step 3 --view pattern -o pattern.svg\n"
      "  kiri export leaf.kiri --view pattern --as-folded -o pattern.fold\n"
      "  kiri export ship.kiri --layer-gap 0.1 --two-sided -o ship.obj");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
