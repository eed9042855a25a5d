// Steps written back as the words of model_text.h, so that a failure can be copied into a test.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

std::string numberText(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}
std::string pointText(Vec2 p) { return " " + numberText(p.x) + "," + numberText(p.y); }
std::string placeText(const Place& place) {
  return std::string(place.frame == Frame::Model ? " m:" : " p:") +
         pointText(place.point).substr(1);
}
std::string placesText(const std::vector<Place>& places) {
  std::string text;
  for (const Place& place : places) text += placeText(place);
  return text;
}
std::string pointsText(const std::vector<Vec2>& points) {
  std::string text;
  for (const Vec2 p : points) text += pointText(p);
  return text;
}
std::string frameText(Frame frame) { return frame == Frame::Model ? " @model" : ""; }
std::string inText(const std::optional<Vec2>& facet) {
  return facet ? " in" + pointText(*facet) : "";
}
std::string lineText(const DrawnLine& line) { return pointText(line.from) + pointText(line.to); }
std::string keepText(const Keep& keep) {
  return keep.places.empty() ? "" : " keep" + placesText(keep.places);
}

std::string layersText(const LayerChoice& layers) {
  if (const auto* top = std::get_if<TopLayers>(&layers))
    return " top " + std::to_string(top->count);
  if (const auto* chosen = std::get_if<ChosenLayers>(&layers))
    return " facets" + placesText(chosen->facets);
  if (std::holds_alternative<ThroughAll>(layers)) return " through";
  return "";
}

std::string edgesText(const LayerChoice& layers) {
  return std::holds_alternative<AllLayers>(layers) ? " layers all" : layersText(layers);
}

std::string movingText(const MovingSide& moving) {
  if (const auto* hand = std::get_if<Hand>(&moving))
    return *hand == Hand::Left ? " left" : " right";
  if (const auto* point = std::get_if<MovingPoint>(&moving)) return " to" + placeText(point->place);
  return " moving" + placesText(std::get<MovingFacets>(moving).facets);
}

/// Names of fold lines as words without spaces stay themselves; others cannot be written in one
/// word.
std::string foldLineText(const FoldLineName& name) {
  if (const auto* place = std::get_if<Place>(&name)) return placeText(*place);
  std::string word = std::get<std::string>(name);
  for (char& c : word) {
    if (c == ' ') c = '_';
  }
  return " " + word;
}
std::string foldLinesText(const std::vector<FoldLineName>& names, Sequence sequence) {
  std::string text;
  for (const FoldLineName& name : names) text += foldLineText(name);
  return text + (sequence == Sequence::Together ? " together" : "");
}

struct Writer {
  std::string operator()(const FoldStep& s) const {
    return "fold " + (s.name.empty() ? "" : s.name + " ") +
           (s.type == FoldType::Valley ? "valley " : "mountain ") + numberText(s.angle) +
           frameText(s.line.frame) + lineText(s.line) + movingText(s.moving) +
           layersText(s.layers) + inText(s.line.facet);
  }
  std::string operator()(const AngleStep& s) const {
    return "angle" + foldLineText(s.line) + " " + numberText(s.angle);
  }
  std::string operator()(const UnfoldStep& s) const {
    return "unfold" + foldLinesText(s.lines, s.sequence);
  }
  std::string operator()(const RefoldStep& s) const {
    return "refold" + foldLinesText(s.lines, s.sequence);
  }
  std::string operator()(const TearStep& s) const {
    return "tear" + frameText(s.path.frame) + pointsText(s.path.points) + edgesText(s.layers);
  }
  std::string operator()(const MendStep& s) const {
    return "mend" + frameText(s.path.frame) + pointsText(s.path.points) + edgesText(s.layers);
  }
  std::string operator()(const AddEdgeStep& s) const {
    return "edge" + frameText(s.line.frame) + lineText(s.line) + layersText(s.layers) +
           inText(s.line.facet);
  }
  std::string operator()(const StraightCutStep& s) const {
    return "cut" + frameText(s.line.frame) + lineText(s.line) + layersText(s.layers) +
           inText(s.line.facet) + keepText(s.keep);
  }
  std::string operator()(const CurveCutStep& s) const {
    return "curve" + frameText(s.frame) + pointsText(s.controls) + (s.isClosed ? " closed" : "") +
           (s.ends == SplineEnds::Free ? " free" : "") + layersText(s.layers) + inText(s.facet) +
           keepText(s.keep);
  }
  std::string operator()(const TurnOverStep& s) const {
    return s.axis == TurnAxis::Vertical ? "turn vertical" : "turn horizontal";
  }
  std::string operator()(const RotateStep& s) const {
    return "rotate " + numberText(s.degrees) + (s.about ? pointText(*s.about) : "");
  }
  std::string operator()(const MoveStep& s) const { return "move" + pointText(s.by); }
  std::string operator()(const PatternStep& s) const {
    std::string text = "pattern " + (s.name.empty() ? "" : s.name) + pointsText(s.vertices);
    for (const PatternCrease& c : s.creases) {
      text += " " + std::to_string(c.from) + "-" + std::to_string(c.to) + ":" + numberText(c.angle);
    }
    return text + (s.isFolded ? " folded" : "");
  }
};

std::string sheetText(const SheetSpec& sheet) {
  const std::string width = numberText(sheet.width);
  switch (sheet.shape) {
    case SheetSpec::Shape::Square:
      return "square " + width;
    case SheetSpec::Shape::Rectangle:
      return "rectangle " + width + " " + numberText(sheet.height);
    case SheetSpec::Shape::Disc:
      return "disc " + width;
    case SheetSpec::Shape::Polygon:
      break;
  }
  std::string text = "polygon" + pointsText(sheet.outline);
  for (const std::vector<Vec2>& hole : sheet.holes) text += " hole" + pointsText(hole);
  return text;
}

}  // namespace

std::string textOf(const Step& step) { return std::visit(Writer{}, step.action); }

std::string textOf(const Model& model) {
  std::string text = sheetText(model.sheet);
  for (const Step& step : model.steps) text += ";\n" + textOf(step);
  return text;
}

}  // namespace kiri::test
