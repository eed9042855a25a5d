// What a step is, in a few words.
// SPDX-License-Identifier: MIT
#include "core/base/text.h"
#include "core/model/requests.h"
#include "editor/document/step_fields.h"

namespace kiri {
namespace {

std::string textOf(const FoldLineName& line) {
  const std::string* name = std::get_if<std::string>(&line);
  return name != nullptr ? *name : text(std::get<Place>(line).point);
}

std::string textOf(const std::vector<FoldLineName>& lines) {
  std::string names;
  for (const FoldLineName& line : lines) names += (names.empty() ? "" : ", ") + textOf(line);
  return names;
}

/// One function for each kind of step.
class Summing {
 public:
  explicit Summing(std::size_t number) : number_(static_cast<int>(number)) {}

  Phrase operator()(const FoldStep& step) const {
    const std::vector<std::string> arguments{foldName(step, number_), text(step.angle)};
    if (step.type == FoldType::Valley)
      return {KIRI_TEXT("editor/document", "%1: valley, %2°"), arguments};
    return {KIRI_TEXT("editor/document", "%1: mountain, %2°"), arguments};
  }
  Phrase operator()(const AngleStep& step) const {
    return {KIRI_TEXT("editor/document", "%1 to %2°"), {textOf(step.line), text(step.angle)}};
  }
  Phrase operator()(const UnfoldStep& step) const {
    const bool isTogether = step.sequence == Sequence::Together;
    if (!step.lines.empty())
      return {KIRI_TEXT("editor/document", "unfold %1"), {textOf(step.lines)}};
    if (isTogether) return {KIRI_TEXT("editor/document", "unfold all together"), {}};
    return {KIRI_TEXT("editor/document", "unfold all in order"), {}};
  }
  Phrase operator()(const RefoldStep& step) const {
    const bool isTogether = step.sequence == Sequence::Together;
    if (!step.lines.empty())
      return {KIRI_TEXT("editor/document", "fold %1 again"), {textOf(step.lines)}};
    if (isTogether) return {KIRI_TEXT("editor/document", "fold all again together"), {}};
    return {KIRI_TEXT("editor/document", "fold all again in order"), {}};
  }
  Phrase operator()(const TearStep&) const { return {KIRI_TEXT("editor/document", "tear"), {}}; }
  Phrase operator()(const MendStep& step) const {
    if (step.path.points.empty()) return {KIRI_TEXT("editor/document", "mend all"), {}};
    return {KIRI_TEXT("editor/document", "mend"), {}};
  }
  Phrase operator()(const AddEdgeStep&) const {
    return {KIRI_TEXT("editor/document", "new edge"), {}};
  }
  Phrase operator()(const StraightCutStep&) const {
    return {KIRI_TEXT("editor/document", "straight cut"), {}};
  }
  Phrase operator()(const CurveCutStep&) const {
    return {KIRI_TEXT("editor/document", "curve cut"), {}};
  }
  Phrase operator()(const TurnOverStep&) const {
    return {KIRI_TEXT("editor/document", "turn over"), {}};
  }
  Phrase operator()(const RotateStep& step) const {
    return {KIRI_TEXT("editor/document", "rotate by %1°"), {text(step.degrees)}};
  }
  Phrase operator()(const MoveStep& step) const {
    return {KIRI_TEXT("editor/document", "move by %1 mm"), {text(step.by)}};
  }
  Phrase operator()(const PatternStep& step) const {
    const std::vector<std::string> arguments{std::to_string(step.creases.size())};
    if (step.isFolded)
      return {KIRI_TEXT("editor/document", "crease pattern, %1 creases, folded"), arguments};
    return {KIRI_TEXT("editor/document", "crease pattern, %1 creases"), arguments};
  }

 private:
  int number_;
};

}  // namespace

Phrase summaryOf(const Step& step, std::size_t number) {
  return std::visit(Summing(number), step.action);
}

}  // namespace kiri
