// Points become the outline of a sheet that nobody folds.
// SPDX-License-Identifier: MIT
#include "apps/cli/outline_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/cli/pattern_import.h"
#include "core/base/text.h"
#include "core/geometry/bounds.h"
#include "io/patterns/outline_points.h"

namespace kiri::cli {

namespace {

/// How near to the outline the origin must lie to mean the petiole, as part of its box.
constexpr double kAtOrigin = 0.02;

/// By its ending, or where that says nothing, by its first line: no JSON, no XML, no pattern.
bool isPoints(const InputText& text) {
  if (isNamedLikePoints(text.fileName)) return true;
  if (!text.fileName.empty() || isPattern(text)) return false;
  const std::size_t first = text.text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string::npos && text.text[first] != '{' && text.text[first] != '<';
}

std::optional<Vec2> originAt(const std::vector<Vec2>& points) {
  const Box box = boundsOf(points);
  const double within = kAtOrigin * distance(box.low, box.high);
  const bool isThere =
      std::any_of(points.begin(), points.end(), [within](Vec2 p) { return length(p) <= within; });
  return isThere ? std::optional(Vec2{}) : std::nullopt;
}

Result<OutlineInput> fromPoints(Console& console, const InputText& text,
                                const OutlineOptions& options) {
  Result<OutlinePoints> read = readOutlinePoints(text.text, text.name);
  if (!read) return read.error();
  for (const std::string& line : read->notes) console.err << "note: " << line << '\n';
  for (Vec2& p : read->points) {
    p = Vec2{p.x, options.isYDown ? 0 - p.y : p.y} * options.mmPerUnit;
  }
  OutlineInput out;
  out.origin = originAt(read->points);
  out.input.name = text.name;
  out.input.folder = text.folder;
  out.input.model.sheet.shape = SheetSpec::Shape::Polygon;
  out.input.model.sheet.outline = std::move(read->points);
  if (const Result<Sheet> sheet = makeSheet(out.input.model.sheet); !sheet) {
    return Error{sheet.error().code, text.name + ": " + sheet.error().message};
  }
  return out;
}

}  // namespace

void addOutlineOptions(CLI::App& command, OutlineOptions& options) {
  command
      .add_option("--mm-per-unit", options.mmPerUnit,
                  "of an outline of points: what 1 in the file is in mm; 10 for cm (default 1)")
      ->type_name("MM");
  command.add_flag("--y-down", options.isYDown,
                   "of an outline of points: y points down, as in images");
}

Status checkOutlineOptions(const OutlineOptions& options) {
  if (options.mmPerUnit > 0 && std::isfinite(options.mmPerUnit)) return std::monostate{};
  return Error{ErrorCode::BadValue, "--mm-per-unit takes a length above 0 mm"};
}

Result<OutlineInput> loadOutline(Console& console, const std::string& path,
                                 const OutlineOptions& options) {
  const Result<InputText> text = readInput(console, path);
  if (!text) return text.error();
  if (isPoints(*text)) return fromPoints(console, *text, options);
  Result<ModelInput> input =
      isPattern(*text) ? modelFromPattern(console, *text) : modelFrom(console, *text);
  if (!input) return input.error();
  return OutlineInput{std::move(*input), std::nullopt};
}

}  // namespace kiri::cli
