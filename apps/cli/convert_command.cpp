// kiri convert: crease patterns and models from one format into another.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "apps/cli/commands.h"
#include "apps/cli/export_formats.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_format.h"
#include "apps/cli/pattern_import.h"
#include "apps/cli/pattern_output.h"
#include "io/kiri_writer.h"

namespace kiri::cli {

namespace {

struct ConvertOptions {
  std::string from;
  std::string to;
  std::string format;
  ImportOptions import;
};

/// Loose lines stay loose lines: nothing is repaired, moved or scaled.
int convertPattern(Console& console, const InputText& text, const ConvertOptions& options,
                   PatternFormat format) {
  const Result<PatternFile> file = readPattern(text.text, text.name);
  if (!file.isOk()) return fail(console, file.error());
  for (const std::string& note : file->notes) console.err << "note: " << note << '\n';
  const WrittenPattern written = writePattern(*file, format);
  return writeWithNotes(console, options.to, written.text, written.losses);
}

int convertModel(Console& console, const ModelInput& input, const ConvertOptions& options,
                 const std::string& format) {
  if (format == "kiri") return writeResult(console, options.to, writeKiri(input.model));
  const Result<StepChoice> last = chooseStep(input, std::nullopt);
  if (!last.isOk()) return fail(console, last.error());
  const Result<Replay> replay = replayFirst(console, input, last->done);
  if (!replay.isOk()) return fail(console, replay.error());
  const auto state = stateAt(console, input, *replay, *last);
  if (!state.isOk()) return fail(console, state.error());
  const std::optional<PatternFormat> pattern = patternFormatNamed(format);
  const Exported out = pattern ? patternOfState(input, **state, *pattern)
                               : exportedAs(console, format, {input, *replay, *last, **state}, {});
  return writeWithNotes(console, options.to, out.text, out.losses);
}

Status checkConvert(const ConvertOptions& options, const std::string& format, bool fromPattern) {
  if (options.import.isDefault()) return std::monostate{};
  if (!fromPattern) {
    return Error{ErrorCode::BadValue,
                 "--size, --flat and --state say how a crease pattern becomes a model; " +
                     options.from + " is a model already"};
  }
  if (!patternFormatNamed(format)) return checkImport(options.import);
  return Error{ErrorCode::BadValue,
               "--size, --flat and --state go with models; from one pattern format to another "
               "nothing is moved"};
}

int run(Console& console, const ConvertOptions& options) {
  const Result<std::string> format = chooseFormat(
      options.to, options.format, {"fold", "cp", "opx", "svg", "dxf", "kiri", "obj", "stl", "glb"});
  if (!format.isOk()) return fail(console, format.error(), kBadUsage);
  const Result<InputText> text = readInput(console, options.from);
  if (!text.isOk()) return fail(console, text.error());
  const bool fromPattern = isPattern(*text);
  const Status usage = checkConvert(options, *format, fromPattern);
  if (!usage.isOk()) return fail(console, usage.error(), kBadUsage);
  const std::optional<PatternFormat> pattern = patternFormatNamed(*format);
  if (fromPattern && pattern) return convertPattern(console, *text, options, *pattern);
  const Result<ModelInput> model =
      fromPattern ? modelFromPattern(console, *text, options.import) : modelFrom(console, *text);
  if (!model.isOk()) return fail(console, model.error());
  return convertModel(console, *model, options, *format);
}

}  // namespace

void addConvertCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("convert", "Turn crease patterns and models into other formats");
  const auto options = std::make_shared<ConvertOptions>();
  command
      ->add_option(
          "A", options->from,
          "a crease pattern (.fold, .cp, .opx, .svg, .dxf) or a .kiri file, - for standard "
          "input")
      ->required();
  command->add_option("B", options->to, "file to write, - for standard output")->required();
  command
      ->add_option("--format", options->format,
                   "fold, cp, opx, svg, dxf, kiri, obj, stl or glb (default: by the ending of B)")
      ->type_name("FORMAT");
  addImportOptions(*command, options->import);
  command->footer(
      "Between pattern formats all lines keep their coordinates; what a format cannot hold is\n"
      "listed before it is written.\n\n"
      "Examples:\n"
      "  kiri convert crane.cp crane.fold\n"
      "  kiri convert crane.cp crane.kiri --size 200\n"
      "  kiri convert crane.fold crane.kiri --state 3\n"
      "  kiri convert crane.kiri crane.svg\n"
      "  kiri convert - - --format dxf < crane.cp > crane.dxf");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
