// Steps into a .kiri file. What equals the default is left out where that reads well.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/places_json.h"
#include "io/steps_json.h"

namespace kiri {

namespace {

void addLayers(JsonValue& out, const LayerChoice& layers, Frame frame,
               const LayerChoice& unsaid = AllLayers{}) {
  if (layers != unsaid) out.add("layers", writeLayers(layers, frame));
}

void addFolds(JsonValue& out, const std::vector<FoldLineName>& lines, Sequence sequence) {
  if (!lines.empty()) {
    JsonValue& folds = out.add("folds", JsonValue::array());
    for (const FoldLineName& line : lines) folds.items.push_back(writeFoldLineName(line));
  }
  if (sequence == Sequence::Together) out.add("sequence", JsonValue::ofText("together"));
}

JsonValue writeCrease(const PatternCrease& crease) {
  JsonValue out = JsonValue::array();
  out.items.push_back(JsonValue::ofNumber(crease.from));
  out.items.push_back(JsonValue::ofNumber(crease.to));
  const auto at =
      std::find(std::begin(kCreaseAssignments), std::end(kCreaseAssignments), crease.assignment);
  KIRI_CHECK(at != std::end(kCreaseAssignments), "the border is no crease of a step");
  const auto letter = static_cast<std::size_t>(at - std::begin(kCreaseAssignments));
  out.items.push_back(JsonValue::ofText(creaseLetters()[letter]));
  if (crease.angle != usualAngle(crease.assignment))
    out.items.push_back(JsonValue::ofNumber(crease.angle));
  return out;
}

/// Appends the fields of each kind of step.
struct ActionWriter {
  JsonValue& out;

  void operator()(const FoldStep& fold) const {
    if (!fold.name.empty()) out.add("name", JsonValue::ofText(fold.name));
    out.add("line", writeLine(fold.line));
    out.add("type", JsonValue::ofText(fold.type == FoldType::Valley ? "valley" : "mountain"));
    out.add("angle", JsonValue::ofNumber(fold.angle));
    addLayers(out, fold.layers, fold.line.frame);
    out.add("move", writeMoving(fold.moving, fold.line.frame));
  }
  void operator()(const AngleStep& step) const {
    out.add("fold", writeFoldLineName(step.line));
    out.add("angle", JsonValue::ofNumber(step.angle));
  }
  void operator()(const UnfoldStep& step) const { addFolds(out, step.lines, step.sequence); }
  void operator()(const RefoldStep& step) const { addFolds(out, step.lines, step.sequence); }
  void operator()(const TearStep& tear) const {
    out.add("path", writePath(tear.path));
    addLayers(out, tear.layers, tear.path.frame, OwnEdges{});
  }
  void operator()(const MendStep& mend) const {
    out.add("path", mend.path.points.empty() ? JsonValue::ofText(kAll) : writePath(mend.path));
    addLayers(out, mend.layers, mend.path.frame, OwnEdges{});
  }
  void operator()(const AddEdgeStep& step) const {
    out.add("line", writeLine(step.line));
    addLayers(out, step.layers, step.line.frame);
  }
  void operator()(const StraightCutStep& cut) const {
    out.add("line", writeLine(cut.line));
    addLayers(out, cut.layers, cut.line.frame);
    out.add("keep", writeKeep(cut.keep, cut.line.frame));
  }
  void operator()(const CurveCutStep& cut) const {
    JsonValue& curve = out.add("curve", JsonValue::object());
    curve.add(cut.frame == Frame::Model ? "model" : "paper", writePoints(cut.controls));
    if (cut.facet && cut.frame == Frame::Paper) curve.add("facet", writePoint(*cut.facet));
    if (cut.isClosed) curve.add("closed", JsonValue::ofBool(true));
    if (cut.ends == SplineEnds::Free) curve.add("ends", JsonValue::ofText("free"));
    addLayers(out, cut.layers, cut.frame);
    out.add("keep", writeKeep(cut.keep, cut.frame));
  }
  void operator()(const TurnOverStep& step) const {
    if (step.axis == TurnAxis::Horizontal) out.add("axis", JsonValue::ofText("horizontal"));
  }
  void operator()(const RotateStep& rotate) const {
    out.add("degrees", JsonValue::ofNumber(rotate.degrees));
    if (rotate.about) out.add("about", writePoint(*rotate.about));
  }
  void operator()(const MoveStep& move) const { out.add("by", writePoint(move.by)); }
  void operator()(const PatternStep& step) const {
    if (!step.name.empty()) out.add("name", JsonValue::ofText(step.name));
    out.add("vertices", writePoints(step.vertices));
    JsonValue& creases = out.add("creases", JsonValue::array());
    creases.items.reserve(step.creases.size());
    for (const PatternCrease& crease : step.creases) creases.items.push_back(writeCrease(crease));
    if (step.isFolded) out.add("folded", JsonValue::ofBool(true));
    if (step.resting) out.add("resting", writePoint(*step.resting));
    if (!step.layers.empty()) out.add("layers", writePoints(step.layers));
    if (step.exceptions.empty()) return;
    JsonValue& exceptions = out.add("exceptions", JsonValue::array());
    for (const auto& [upper, lower] : step.exceptions)
      exceptions.items.push_back(writePoints({upper, lower}));
  }
};

}  // namespace

const std::vector<std::string>& stepKinds() {
  static const std::vector<std::string> kinds = {
      "fold",         "angle",     "unfold",    "refold", "tear", "mend",   "add edge",
      "straight cut", "curve cut", "turn over", "rotate", "move", "pattern"};
  return kinds;
}

const std::vector<std::string>& creaseLetters() {
  static const std::vector<std::string> letters = {"M", "V", "F", "U", "C", "J"};
  return letters;
}

double usualAngle(Assignment assignment) {
  constexpr double kFull = 180;
  switch (assignment) {
    case Assignment::Mountain:
      return -kFull;
    case Assignment::Valley:
    case Assignment::Unassigned:
      return kFull;
    default:
      return 0;
  }
}

const std::string& kindOf(const Step& step) { return stepKinds()[step.action.index()]; }

std::string describeStep(const Step& step, std::size_t number) {
  std::string name = step.title;
  if (const auto* fold = std::get_if<FoldStep>(&step.action);
      fold != nullptr && !fold->name.empty()) {
    name = fold->name;
  }
  return "step " + std::to_string(number) + " (" + kindOf(step) +
         (name.empty() ? "" : " " + jsonString(name)) + ")";
}

JsonValue writeStep(const Step& step) {
  JsonValue out = JsonValue::object();
  out.add("do", JsonValue::ofText(kindOf(step)));
  if (!step.title.empty()) out.add("title", JsonValue::ofText(step.title));
  std::visit(ActionWriter{out}, step.action);
  if (!step.notes.empty()) out.add("notes", JsonValue::ofText(step.notes));
  mergeUnknown(out, step.unknown);
  return out;
}

}  // namespace kiri
