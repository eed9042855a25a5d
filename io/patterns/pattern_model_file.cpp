// SPDX-License-Identifier: MIT
#include "io/patterns/pattern_model_file.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/geometry/bounds.h"

namespace kiri {
namespace {

/// The longest side of the box of all lines that have a place.
double longestSideOf(const CreaseDrawing& drawing) {
  Box box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const DrawnCrease& line : drawing.lines) {
    for (const Vec2 p : {line.from, line.to}) {
      if (std::isfinite(p.x) && std::isfinite(p.y)) box = joined(box, p);
    }
  }
  return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

void append(std::string& text, const std::string& more) {
  if (!more.empty()) text += (text.empty() ? "" : "\n") + more;
}

}  // namespace

PatternScale scaleOf(const PatternFile& file) {
  if (file.mmPerUnit) return {*file.mmPerUnit, ""};
  constexpr double kLeast = 10;
  constexpr double kMost = 2000;
  constexpr double kUsual = 150;
  const double longest = longestSideOf(file.drawing);
  if (!(longest > 0) || !std::isfinite(longest) || (longest >= kLeast && longest <= kMost))
    return {};
  return {kUsual / longest, "the file does not say how large its unit is; its longest side, " +
                                text(longest) + " units, was taken to be " + text(kUsual) + " mm"};
}

Result<PatternOfFile> patternOfFile(const PatternFile& file, const Progress& progress) {
  const PatternScale scale = scaleOf(file);
  RepairOptions repairs;
  repairs.scale = scale.mmPerUnit;
  Result<RepairedPattern> repaired = patternOf(file.drawing, repairs, progress);
  if (!repaired) return repaired.error();
  PatternOfFile out{std::move(*repaired), file.drawing.orders, file.notes};
  for (DrawnOrder& order : out.orders) {
    order.upper = order.upper * scale.mmPerUnit;
    order.lower = order.lower * scale.mmPerUnit;
  }
  if (!scale.note.empty()) out.notes.push_back(scale.note);
  for (const Repair& repair : out.repaired.repairs) out.notes.push_back(repair.message);
  return out;
}

Result<PatternModel> modelOfFile(const PatternFile& file, PatternModelOptions options,
                                 const Progress& progress) {
  Result<PatternOfFile> pattern = patternOfFile(file, progress);
  if (!pattern) return pattern.error();
  if (options.title.empty()) options.title = file.title;
  if (options.orders.empty()) options.orders = std::move(pattern->orders);
  Result<PatternModel> made = modelOf(pattern->repaired.creases, options, progress);
  if (!made) return made;
  append(made->model.notes, file.author.empty() ? "" : "By " + file.author);
  append(made->model.notes, file.description);
  made->notes.insert(made->notes.begin(), pattern->notes.begin(), pattern->notes.end());
  return made;
}

PatternFile patternFileOf(const FoldedState& state, const Model& model, bool isAsFolded) {
  PatternFile file;
  const AssignedPattern creases = assignedPatternOf(state, isAsFolded);
  file.drawing = drawingOf(creases);
  // Orders are those of the state as it lies: creases that are flat in it have none to tell.
  const bool isAsItLies = creases.pattern.edges.size() == state.pattern.edges.size() &&
                          std::equal(creases.pattern.edges.begin(), creases.pattern.edges.end(),
                                     state.pattern.edges.begin(), [](const Edge& a, const Edge& b) {
                                       return a.angle == b.angle;
                                     });
  if (isAsItLies) file.drawing.orders = drawnOrdersOf(state);
  file.title = model.title;
  file.description = model.notes;
  file.mmPerUnit = 1;
  if (!state.pattern.curves.empty()) {
    file.notes.push_back("curved edges became polylines: " +
                         std::to_string(state.pattern.curves.size()));
  }
  return file;
}

}  // namespace kiri
