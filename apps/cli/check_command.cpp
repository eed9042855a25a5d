// kiri check: does a crease pattern fold flat, and if not, where and why.
// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <utility>

#include "apps/cli/check_report.h"
#include "apps/cli/commands.h"
#include "apps/cli/output_format.h"
#include "apps/cli/pattern_input.h"
#include "apps/cli/picture_options.h"
#include "render/scene/pattern_check_scene.h"

namespace kiri::cli {

namespace {

struct CheckOptions {
  std::string file;
  bool isJson = false;
  bool setsCode = false;
  PictureOptions picture;
};

Status checkUsage(const CheckOptions& options) {
  if (options.picture.out.empty()) return std::monostate{};
  const Result<std::string> format = checkPictureOptions(options.picture);
  if (!format.isOk()) return format.error();
  if (options.picture.out != "-" || !options.isJson) return std::monostate{};
  return Error{ErrorCode::BadValue,
               "-o - and --json would mix on standard output; name a file for the picture"};
}

int writeFaults(Console& console, const PatternInput& input, const PatternReport& report,
                const PictureOptions& options) {
  const Result<std::string> format = checkPictureOptions(options);
  if (!format.isOk()) return fail(console, format.error(), kBadUsage);
  PatternCheckOptions page;
  page.title = input.title;
  page.verdict = verdictOf(report) + "; " + closingOf(report, input.unit);
  Appearance appearance;
  appearance.lineStyle = options.style == "diagram" ? LineStyle::Diagram : LineStyle::Thesis;
  Scene scene = patternCheckScene(input.creases, report.faults, input.repairs, appearance, page);
  scene.background = Color{255, 255, 255};
  return writePicture(console, std::move(scene), options, *format);
}

std::string checkJson(const PatternInput& input, const PatternReport& report) {
  const CreasePattern& pattern = input.creases.pattern;
  JsonValue out = JsonValue::object();
  out.add("file", JsonValue::ofText(input.name));
  out.add("title", JsonValue::ofText(input.title));
  out.add("format", JsonValue::ofText(input.formatName));
  out.add("unit", JsonValue::ofText(input.unit));
  out.add("vertices", countJson(pattern.vertices.size()));
  out.add("edges", countJson(pattern.edges.size()));
  out.add("faces", countJson(pattern.facets.size()));
  JsonValue& kinds = out.add("creases", JsonValue::object());
  kinds.add("border", countJson(countOf(input.creases, Assignment::Border)));
  kinds.add("mountain", countJson(countOf(input.creases, Assignment::Mountain)));
  kinds.add("valley", countJson(countOf(input.creases, Assignment::Valley)));
  kinds.add("unassigned", countJson(countOf(input.creases, Assignment::Unassigned)));
  kinds.add("flat", countJson(countOf(input.creases, Assignment::Flat)));
  kinds.add("join", countJson(countOf(input.creases, Assignment::Join)));
  kinds.add("cut", countJson(countOf(input.creases, Assignment::Cut)));
  out.add("notes", textsJson(input.notes));
  out.add("repairs", repairsJson(input.repairs));
  out.add("angles_taken_as_180", countJson(input.bentCreases));
  out.add("locally_flat_foldable", JsonValue::ofBool(report.isLocallyFlat()));
  out.add("faulty_vertices", countJson(report.faultyVertices()));
  out.add("standing_vertices", countJson(report.standing));
  out.add("faults", faultsJson(report, pattern));
  out.add("closes", JsonValue::ofBool(report.map.has_value()));
  out.add("closing_error", report.map ? JsonValue::ofNumber(report.map->error) : JsonValue{});
  out.add("closing", JsonValue::ofText(closingOf(report, input.unit)));
  out.add("verdict", JsonValue::ofText(verdictOf(report)));
  constexpr std::size_t kDocument = 1;
  return layOut(out, kDocument);
}

std::string checkText(const PatternInput& input, const PatternReport& report) {
  std::string out = input.name + ": " + input.formatName + ", " + describedAs(input.creases) + "\n";
  for (const VertexFault& fault : report.faults) out += "  " + fault.message + "\n";
  out += verdictOf(report) + "\n";
  return out + closingOf(report, input.unit) + "\n";
}

int run(Console& console, const CheckOptions& options) {
  const Status usage = checkUsage(options);
  if (!usage.isOk()) return fail(console, usage.error(), kBadUsage);
  const Result<PatternInput> input = loadPattern(console, options.file);
  if (!input.isOk()) return fail(console, input.error());
  noteRepairs(console, *input);
  if (isCancelled(console)) return fail(console, Error{ErrorCode::Cancelled, "", {}});
  const PatternReport report = reportOf(input->creases, input->standing);
  if (!options.picture.out.empty()) {
    const int drawn = writeFaults(console, *input, report, options.picture);
    if (drawn != kDone) return drawn;
  }
  const bool isPiped = options.picture.out == "-";
  const int written =
      isPiped ? kDone
              : writeResult(console, "-",
                            options.isJson ? checkJson(*input, report) : checkText(*input, report));
  if (written != kDone) return written;
  return options.setsCode && !report.foldsFlat() ? kVerdictNo : kDone;
}

}  // namespace

void addCheckCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command = app.add_subcommand(
      "check", "Say whether a crease pattern folds flat, and if not, where and why");
  const auto options = std::make_shared<CheckOptions>();
  command
      ->add_option(
          "FILE", options->file,
          "a crease pattern (.fold, .cp, .opx, .svg, .dxf) or a .kiri file, - for standard "
          "input")
      ->required();
  command->add_flag("--json", options->isJson, "one JSON object, for programs");
  command->add_option("-o,--output", options->picture.out, "picture of the pattern, faults marked")
      ->type_name("OUT");
  command
      ->add_option("--format", options->picture.format,
                   "svg, png or pdf (default: by the ending of OUT)")
      ->type_name("FORMAT");
  command->add_option("--dpi", options->picture.dpi, "pixels per inch of a PNG (default 200)")
      ->type_name("N");
  command
      ->add_option("--style", options->picture.style,
                   "thesis: mountain blue, valley red; diagram: black dashes")
      ->type_name("STYLE");
  command->add_flag("--exit-code", options->setsCode, "exit with 5 when it does not fold flat");
  command->footer(
      "Examples:\n"
      "  kiri check crane.cp\n"
      "  kiri check crane.fold -o faults.png\n"
      "  kiri check crane.svg --json\n"
      "  kiri check crane.fold --exit-code && echo it folds");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
