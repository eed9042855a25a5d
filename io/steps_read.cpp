// Steps out of a .kiri file.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/places_json.h"
#include "io/steps_json.h"

namespace kiri {

namespace {

constexpr double kStraightAngle = 180;

LayerChoice layersOf(Fields& fields, Frame frame, const LayerChoice& unsaid = AllLayers{}) {
  const std::optional<Field> field = fields.find("layers");
  return field ? readLayers(*field, frame) : unsaid;
}

Keep keepOf(Fields& fields, Frame frame) {
  const std::optional<Field> field =
      fields.require("keep", "\"all\", or a point [x, y] on each piece of paper that stays");
  return field ? readKeep(*field, frame) : Keep{};
}

DrawnLine lineOf(Fields& fields, const char* meaning) {
  const std::optional<Field> field = fields.require("line", meaning);
  return field ? readLine(*field) : DrawnLine{};
}

FoldStep readFold(Fields& fields) {
  FoldStep fold;
  fold.name = fields.text("name");
  fold.line = lineOf(fields, "the line to fold along");
  if (const std::optional<Field> type = fields.require("type", "\"valley\" or \"mountain\"")) {
    fold.type = type->oneOf({"valley", "mountain"}) == 0 ? FoldType::Valley : FoldType::Mountain;
  }
  fold.angle = fields.number("angle", kStraightAngle, {0, kStraightAngle, false});
  fold.layers = layersOf(fields, fold.line.frame);
  const std::optional<Field> move =
      fields.require("move",
                     "the side that moves: \"left\", \"right\", {\"point\": [x, y]} or "
                     "{\"facets\": [[x, y], ...]}");
  if (move) fold.moving = readMoving(*move, fold.line.frame);
  return fold;
}

AngleStep readAngle(Fields& fields) {
  AngleStep step;
  if (const std::optional<Field> fold =
          fields.require("fold", "the name of a fold, or a place [x, y] on its crease")) {
    step.line = readFoldLineName(*fold);
  }
  if (const std::optional<Field> angle = fields.require("angle", "in degrees, -180 to 180")) {
    step.angle = angle->number({-kStraightAngle, kStraightAngle, false});
  }
  return step;
}

std::vector<FoldLineName> foldsOf(Fields& fields) {
  std::vector<FoldLineName> out;
  const std::optional<Field> field = fields.find("folds");
  if (!field || (field->isText() && field->json().text == kAll)) return out;
  if (!field->isArray() || field->size() == 0) {
    field->isNot("\"all\" or a list with the names of folds");
    return out;
  }
  for (std::size_t i = 0; i < field->size(); ++i) {
    // A bare point would otherwise be read as two places that are no places.
    if (field->looksLikePoint()) {
      field->mistake("must be a list of folds; put the point in brackets once more");
      break;
    }
    out.push_back(readFoldLineName(field->item(i)));
  }
  return out;
}

Sequence sequenceOf(Fields& fields) {
  return fields.oneOf("sequence", {"in order", "together"}, 0) == 0 ? Sequence::InOrder
                                                                    : Sequence::Together;
}

TearStep readTear(Fields& fields) {
  TearStep tear;
  if (const std::optional<Field> path =
          fields.require("path", "the edges to tear, from a vertex on")) {
    tear.path = readPath(*path);
  }
  tear.layers = layersOf(fields, tear.path.frame, OwnEdges{});
  return tear;
}

MendStep readMend(Fields& fields) {
  MendStep mend;
  if (const std::optional<Field> path =
          fields.require("path", "\"all\", or the torn edges to mend")) {
    const bool isAll = path->isText() && path->json().text == kAll;
    if (!isAll && path->isText()) path->isNot("\"all\" or a path {\"paper\": [[x, y], ...]}");
    if (!isAll) mend.path = readPath(*path);
  }
  mend.layers = layersOf(fields, mend.path.frame, OwnEdges{});
  return mend;
}

AddEdgeStep readAddEdge(Fields& fields) {
  AddEdgeStep step;
  step.line = lineOf(fields, "the edge to add");
  step.layers = layersOf(fields, step.line.frame);
  return step;
}

StraightCutStep readStraightCut(Fields& fields) {
  StraightCutStep cut;
  cut.line = lineOf(fields, "the line to cut along");
  cut.layers = layersOf(fields, cut.line.frame);
  cut.keep = keepOf(fields, cut.line.frame);
  return cut;
}

void readCurve(const Field& field, CurveCutStep& cut) {
  Fields fields(field);
  cut.isClosed = fields.flag("closed", false);
  const std::optional<Field> controls =
      fields.requireOneOf({"paper", "model"}, "the control points of the curve in mm");
  if (controls) {
    cut.frame = controls->name() == "model" ? Frame::Model : Frame::Paper;
    cut.controls = controls->points(cut.isClosed ? 3 : 4);
  }
  if (const std::optional<Field> facet = fields.find("facet")) {
    cut.facet = facet->point();
    if (cut.frame == Frame::Model) {
      facet->mistake(
          "goes with a curve on the paper only; take it out or write the curve as \"paper\"");
    }
  }
  cut.ends =
      fields.oneOf("ends", {"clamped", "free"}, 0) == 0 ? SplineEnds::Clamped : SplineEnds::Free;
  fields.finish();
}

CurveCutStep readCurveCut(Fields& fields) {
  CurveCutStep cut;
  if (const std::optional<Field> curve = fields.require("curve", "the curve to cut along")) {
    readCurve(*curve, cut);
  }
  cut.layers = layersOf(fields, cut.frame);
  cut.keep = keepOf(fields, cut.frame);
  return cut;
}

TurnOverStep readTurnOver(Fields& fields) {
  const std::size_t axis = fields.oneOf("axis", {"vertical", "horizontal"}, 0);
  return {axis == 0 ? TurnAxis::Vertical : TurnAxis::Horizontal};
}

RotateStep readRotate(Fields& fields) {
  RotateStep rotate;
  constexpr double kManyTurns = 36'000;
  if (const std::optional<Field> degrees = fields.require("degrees", "counter-clockwise")) {
    rotate.degrees = degrees->number({-kManyTurns, kManyTurns, false});
  }
  if (const std::optional<Field> about = fields.find("about")) rotate.about = about->point();
  return rotate;
}

MoveStep readMove(Fields& fields) {
  const std::optional<Field> by = fields.require("by", "how far to move, [x, y] in mm");
  return {by ? by->point() : Vec2{}};
}

/// [from, to, "V"], and the angle where it is not that of the letter.
PatternCrease readCrease(const Field& field, std::size_t vertices) {
  PatternCrease crease;
  constexpr std::size_t kShort = 3;
  if (!field.isArray() || field.size() < kShort || field.size() > kShort + 1) {
    field.isNot("two numbers of vertices and a letter, such as [0, 1, \"V\"]");
    return crease;
  }
  const Limits range{0, static_cast<double>(vertices) - 1, false};
  const auto vertex = [&](std::size_t i) {
    const double number = field.item(i).number(range);
    if (std::floor(number) != number) field.item(i).isNot("a whole number");
    return field.findings().isGood() ? static_cast<std::uint32_t>(number) : 0;
  };
  crease.from = vertex(0);
  crease.to = vertex(1);
  const std::size_t letter = field.item(2).oneOf(creaseLetters());
  crease.assignment = kCreaseAssignments[std::min(letter, std::size(kCreaseAssignments) - 1)];
  crease.angle = usualAngle(crease.assignment);
  if (field.size() > kShort)
    crease.angle = field.item(kShort).number({-kStraightAngle, kStraightAngle, false});
  return crease;
}

void readExceptions(const Field& field, PatternStep& step) {
  if (!field.isArray()) field.isNot("a list of pairs of places [[upper, lower], ...]");
  for (std::size_t i = 0; i < field.size() && field.findings().isGood(); ++i) {
    const Field pair = field.item(i);
    if (!pair.isArray() || pair.size() != 2) {
      pair.isNot("two places, [[x, y], [x, y]]: the upper facet, the lower facet");
      return;
    }
    const Vec2 upper = pair.item(0).point();
    step.exceptions.emplace_back(upper, pair.item(1).point());
  }
}

PatternStep readPatternStep(Fields& fields) {
  PatternStep step;
  step.name = fields.text("name");
  if (const auto vertices = fields.require("vertices", "the ends of the creases, [[x, y], ...]"))
    step.vertices = vertices->points(0);
  const auto creases = fields.require("creases", "the creases, [[0, 1, \"V\"], ...]");
  if (creases && !creases->isArray()) creases->isNot("a list of creases [[0, 1, \"V\"], ...]");
  if (creases) step.creases.reserve(creases->size());
  for (std::size_t i = 0; creases && i < creases->size() && creases->findings().isGood(); ++i)
    step.creases.push_back(readCrease(creases->item(i), step.vertices.size()));
  step.isFolded = fields.flag("folded", false);
  if (const auto resting = fields.find("resting")) step.resting = resting->point();
  if (const auto layers = fields.find("layers")) step.layers = layers->points(0);
  if (const auto exceptions = fields.find("exceptions")) readExceptions(*exceptions, step);
  return step;
}

Action readAction(std::size_t kind, Fields& fields) {
  using Reader = Action (*)(Fields&);
  static constexpr Reader kReaders[] = {
      [](Fields& f) { return Action{readFold(f)}; },
      [](Fields& f) { return Action{readAngle(f)}; },
      [](Fields& f) {
        return Action{UnfoldStep{foldsOf(f), sequenceOf(f)}};
      },
      [](Fields& f) {
        return Action{RefoldStep{foldsOf(f), sequenceOf(f)}};
      },
      [](Fields& f) { return Action{readTear(f)}; },
      [](Fields& f) { return Action{readMend(f)}; },
      [](Fields& f) { return Action{readAddEdge(f)}; },
      [](Fields& f) { return Action{readStraightCut(f)}; },
      [](Fields& f) { return Action{readCurveCut(f)}; },
      [](Fields& f) { return Action{readTurnOver(f)}; },
      [](Fields& f) { return Action{readRotate(f)}; },
      [](Fields& f) { return Action{readMove(f)}; },
      [](Fields& f) { return Action{readPatternStep(f)}; },
  };
  static_assert(std::size(kReaders) == std::variant_size_v<Action>);
  return kReaders[kind](fields);
}

/// The step's name for messages before it is read: what can be told from its texts.
std::string nameForMessages(const JsonValue& json, std::size_t number) {
  std::string out = "step " + std::to_string(number);
  const JsonValue* kind = json.find("do");
  const JsonValue* name = json.find("name");
  if (name == nullptr) name = json.find("title");
  const auto isShortText = [](const JsonValue* value) {
    constexpr std::size_t kLong = 60;
    return value != nullptr && value->is(JsonValue::Kind::String) && !value->text.empty() &&
           value->text.size() <= kLong;
  };
  std::string inner = isShortText(kind) ? kind->text : "";
  if (isShortText(name)) inner += (inner.empty() ? "" : " ") + jsonString(name->text);
  return inner.empty() ? out : out + " (" + inner + ")";
}

std::optional<std::size_t> readKind(Fields& fields) {
  std::string list;
  for (const std::string& kind : stepKinds()) list += (list.empty() ? "" : ", ") + kind;
  const std::optional<Field> field = fields.require("do", "one of: " + list);
  if (!field) return std::nullopt;
  const std::string kind = field->text();
  for (std::size_t i = 0; i < stepKinds().size(); ++i) {
    if (stepKinds()[i] == kind) return i;
  }
  const std::string meant = nearestName(kind, stepKinds());
  field->findings().mistake(field->json(),
                            "unknown step kind " + jsonString(kind) +
                                (meant.empty() ? "; the kinds are: " + list
                                               : "; did you mean " + jsonString(meant) + "?"));
  return std::nullopt;
}

}  // namespace

Step readStep(const Field& field, std::size_t number) {
  Step step;
  Findings& findings = field.findings();
  findings.enter(nameForMessages(field.json(), number));
  if (!field.isObject()) {
    findings.mistake(field.json(), "a step must be an object in braces { } with \"do\"");
    return step;
  }
  Fields fields(field);
  const std::optional<std::size_t> kind = readKind(fields);
  if (!kind) return step;
  step.title = fields.text("title");
  step.notes = fields.text("notes");
  step.action = readAction(*kind, fields);
  fields.finish();
  step.unknown = findings.takeUnknown();
  return step;
}

}  // namespace kiri
