// kiri export: the model in the formats of other programs.
// SPDX-License-Identifier: MIT
#include <memory>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/export_formats.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_format.h"

namespace kiri::cli {

namespace {

int write(Console& console, const std::string& path, const Exported& exported) {
  const int written = writeResult(console, path, exported.text);
  for (const std::string& loss : exported.losses) console.err << "note: " << loss << '\n';
  return written;
}

int runMotion(Console& console, const ModelInput& input, const ExportOptions& options) {
  const Result<TimelineOptions> time = timelineOptionsOf(options.time, input.model.steps.size());
  if (!time.isOk()) return fail(console, time.error(), kBadUsage);
  const Result<Exported> exported = exportedInMotion(console, input, *time, options);
  if (!exported.isOk()) return fail(console, exported.error());
  return write(console, options.out, *exported);
}

int run(Console& console, const ExportOptions& options) {
  const Result<std::string> format =
      chooseFormat(options.out, options.format, {"fold", "svg", "obj", "stl", "glb"});
  if (!format.isOk()) return fail(console, format.error(), kBadUsage);
  const Status usage = checkExport(options, *format);
  if (!usage.isOk()) return fail(console, usage.error(), kBadUsage);
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  if (options.isAnimated) return runMotion(console, *input, options);
  const Result<StepChoice> moment = chooseStep(*input, options.step);
  if (!moment.isOk()) return fail(console, moment.error(), kBadUsage);
  const Result<Replay> replay = replayFirst(console, *input, moment->done);
  if (!replay.isOk()) return fail(console, replay.error());
  const auto state = stateAt(console, *input, *replay, *moment);
  if (!state.isOk()) return fail(console, state.error());
  if (isCancelled(console)) return fail(console, Error{ErrorCode::Cancelled, "", {}});
  Exported exported;
  {
    ProgressLine line(console, "writing");
    line.update(0);
    exported = exportedAs(console, *format, {*input, *replay, *moment, **state}, options);
  }
  return write(console, options.out, exported);
}

}  // namespace

void addExportCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("export", "Write the model for other programs: FOLD, SVG, OBJ, STL, glTF");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  command->add_option("-o,--output", options->out, "file to write, - for standard output")
      ->type_name("OUT")
      ->required();
  command
      ->add_option("--format", options->format,
                   "fold, svg, obj, stl or glb (default: by the ending of OUT)")
      ->type_name("FORMAT");
  addStepOption(*command, options->step);
  command
      ->add_option(
          "--view", options->view,
          "pattern: the crease pattern only; folded: with the folded forms (default, but for svg)")
      ->type_name("VIEW");
  command->add_flag(
      "--as-folded", options->isAsFolded,
      "pattern: creases of an open model get the angle that their fold last gave them");
  command->add_flag("--two-sided", options->isTwoSided, "obj: triangles for the back as well");
  command
      ->add_option("--layer-gap", options->layerGap,
                   "obj, stl, glb: mm between the layers of a plane (default 0; glb: 0.05)")
      ->type_name("MM");
  command
      ->add_option("--thickness", options->thickness,
                   "obj, stl, glb: closed plates of so many mm (default 0; stl: 0.3)")
      ->type_name("MM");
  command->add_flag("--animate", options->isAnimated,
                    "glb: all steps in motion, for viewers that play animations");
  addTimeOptions(*command, options->time);
  command->footer(
      "Examples:\n"
      "  kiri export leaf.kiri -o leaf.fold\n"
      "  kiri export leaf.kiri --step 3 --view pattern -o pattern.svg\n"
      "  kiri export leaf.kiri --view pattern --as-folded -o pattern.fold\n"
      "  kiri export ship.kiri --layer-gap 0.1 --two-sided -o ship.obj\n"
      "  kiri export ship.kiri --thickness 0.4 -o ship.stl\n"
      "  kiri export ship.kiri -o ship.glb\n"
      "  kiri export ship.kiri --animate -o ship_in_motion.glb");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
