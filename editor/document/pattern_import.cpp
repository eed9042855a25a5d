// From the text of a pattern to a model that opens.
// SPDX-License-Identifier: MIT
#include "editor/document/pattern_import.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/model/pattern_model.h"
#include "core/paper/boxes.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

namespace {

std::string stemOf(const std::string& fileName) {
  const std::size_t slash = fileName.find_last_of("/\\");
  const std::string name = slash == std::string::npos ? fileName : fileName.substr(slash + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

/// Repairs know places of the drawing; the sheet of the model may lie elsewhere and be larger.
void movePlaces(std::vector<Repair>& repairs, const Box& drawn, const Box& sheet) {
  const double width = std::max(drawn.high.x - drawn.low.x, drawn.high.y - drawn.low.y);
  if (!(width > 0)) return;
  const double scale = std::max(sheet.high.x - sheet.low.x, sheet.high.y - sheet.low.y) / width;
  for (Repair& repair : repairs) {
    for (Vec2& place : repair.places) place = sheet.low + (place - drawn.low) * scale;
    repair.farthest *= scale;
  }
}

/// A model has room for notes only.
std::string notesOf(const PatternFile& file) {
  if (file.author.empty()) return file.description;
  return file.description + (file.description.empty() ? "" : "\n") + file.author;
}

std::vector<std::string> lossesOf(const PatternFile& file) {
  if (file.unknown.empty() || file.unknown == "{}") return {};
  return {
      "what other programs have written into the file is not part of the model; the file "
      "itself stays as it is"};
}

void append(std::vector<std::string>& all, std::vector<std::string> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// A part of the whole work, from `from` to `to`.
Progress part(const Progress& progress, double from, double to) {
  return [&progress, from, to](double done) { return goesOn(progress, from + (to - from) * done); };
}

}  // namespace

Result<PatternImport> importPattern(std::string_view text, const std::string& fileName,
                                    PatternUse use, const Progress& progress) {
  Result<PatternFile> file = readPattern(text, fileName);
  if (!file) return file.error();
  if (!goesOn(progress, 0.05)) return Error{ErrorCode::Cancelled, "", {}};
  RepairOptions repairing;
  repairing.scale = file->mmPerUnit.value_or(1);
  Result<RepairedPattern> repaired = patternOf(file->drawing, repairing, part(progress, 0.05, 0.2));
  if (!repaired) return repaired.error();
  PatternModelOptions options;
  options.title = file->title.empty() ? stemOf(fileName) : file->title;
  options.longestSide = file->mmPerUnit ? 0 : kUnitlessSide;
  options.isFolded = use == PatternUse::Folded;
  options.orders = std::move(file->drawing.orders);
  for (DrawnOrder& order : options.orders) {
    order.upper = order.upper * repairing.scale;
    order.lower = order.lower * repairing.scale;
  }
  Box drawn = paperBoxOf(repaired->creases.pattern);
  drawn.low = drawn.low / repairing.scale;
  drawn.high = drawn.high / repairing.scale;
  Result<PatternModel> made = modelOf(repaired->creases, options, part(progress, 0.2, 1));
  if (!made) return made.error();
  PatternImport import{std::move(made->model),
                       {fileName, std::move(repaired->repairs), {}, lossesOf(*file)}};
  import.model.notes = notesOf(*file);
  if (const Result<Sheet> sheet = makeSheet(import.model.sheet)) {
    movePlaces(import.report.repairs, drawn, paperBoxOf(patternOf(*sheet)));
  }
  append(import.report.notes, std::move(file->notes));
  append(import.report.notes, std::move(made->notes));
  return import;
}

bool isPatternName(std::string_view fileName) { return patternFormatOf(fileName).has_value(); }

bool isPatternText(std::string_view text) { return sniffedFormat(text).has_value(); }

}  // namespace kiri
