// Steps into a .kiri file. What equals the default is left out where that reads well.
// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/places_json.h"
#include "io/steps_json.h"

namespace kiri {

namespace {

void addLayers(JsonValue& out, const LayerChoice& layers, Frame frame) {
  if (!std::holds_alternative<AllLayers>(layers)) out.add("layers", writeLayers(layers, frame));
}

void addFolds(JsonValue& out, const std::vector<FoldLineName>& lines, Sequence sequence) {
  if (!lines.empty()) {
    JsonValue& folds = out.add("folds", JsonValue::array());
    for (const FoldLineName& line : lines) folds.items.push_back(writeFoldLineName(line));
  }
  if (sequence == Sequence::Together) out.add("sequence", JsonValue::ofText("together"));
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
    addLayers(out, tear.layers, tear.path.frame);
  }
  void operator()(const MendStep& mend) const {
    out.add("path", mend.path.points.empty() ? JsonValue::ofText(kAll) : writePath(mend.path));
    addLayers(out, mend.layers, mend.path.frame);
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
};

}  // namespace

const std::vector<std::string>& stepKinds() {
  static const std::vector<std::string> kinds = {
      "fold",     "angle",        "unfold",    "refold",    "tear",   "mend",
      "add edge", "straight cut", "curve cut", "turn over", "rotate", "move"};
  return kinds;
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
