// SPDX-License-Identifier: MIT
#include "core/model/numbers.h"

#include <cmath>

#include "core/base/text.h"

namespace kiri {
namespace {

/// Coordinates beyond this, in mm, belong to no model; their squares stay finite.
constexpr double kFarthest = 1e9;

/// Walks through all numbers of a step and remembers the first that is none.
class Numbers {
 public:
  void operator()(const FoldStep& s) {
    line(s.line);
    angle(s.angle);
    layers(s.layers);
    if (const MovingPoint* point = std::get_if<MovingPoint>(&s.moving)) place(point->place.point);
    if (const MovingFacets* facets = std::get_if<MovingFacets>(&s.moving)) places(facets->facets);
  }
  void operator()(const AngleStep& s) {
    name(s.line);
    angle(s.angle);
  }
  void operator()(const UnfoldStep& s) {
    for (const FoldLineName& line : s.lines) name(line);
  }
  void operator()(const RefoldStep& s) {
    for (const FoldLineName& line : s.lines) name(line);
  }
  void operator()(const TearStep& s) {
    points(s.path.points);
    layers(s.layers);
  }
  void operator()(const MendStep& s) {
    points(s.path.points);
    layers(s.layers);
  }
  void operator()(const AddEdgeStep& s) {
    line(s.line);
    layers(s.layers);
  }
  void operator()(const StraightCutStep& s) {
    line(s.line);
    layers(s.layers);
    places(s.keep.places);
  }
  void operator()(const CurveCutStep& s) {
    points(s.controls);
    if (s.facet) place(*s.facet);
    layers(s.layers);
    places(s.keep.places);
  }
  void operator()(const TurnOverStep&) {}
  void operator()(const RotateStep& s) {
    angle(s.degrees);
    if (s.about) place(*s.about);
  }
  void operator()(const MoveStep& s) { place(s.by); }
  void operator()(const PatternStep& s) {
    points(s.vertices);
    for (const PatternCrease& crease : s.creases) angle(crease.angle);
    if (s.resting) place(*s.resting);
    points(s.layers);
    for (const auto& [upper, lower] : s.exceptions) points({upper, lower});
  }

  Status result() const { return result_; }

 private:
  void refuse(const std::string& what) {
    if (result_) result_ = Error{ErrorCode::BadValue, what, {}};
  }
  void angle(double degrees) {
    if (!std::isfinite(degrees)) refuse("the angle is not a number; give degrees");
  }
  void place(Vec2 p) {
    if (std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest) return;
    refuse("the point " + text(p) + " is no place in mm; give two numbers of an ordinary size");
  }
  void points(const std::vector<Vec2>& all) {
    for (const Vec2 p : all) place(p);
  }
  void places(const std::vector<Place>& all) {
    for (const Place& p : all) place(p.point);
  }
  void name(const FoldLineName& line) {
    if (const Place* p = std::get_if<Place>(&line)) place(p->point);
  }
  void line(const DrawnLine& drawn) {
    place(drawn.from);
    place(drawn.to);
    if (drawn.facet) place(*drawn.facet);
  }
  void layers(const LayerChoice& choice) {
    if (const ChosenLayers* chosen = std::get_if<ChosenLayers>(&choice)) places(chosen->facets);
  }

  Status result_ = std::monostate{};
};

}  // namespace

Status checkNumbers(const Step& step) {
  Numbers numbers;
  std::visit(numbers, step.action);
  return numbers.result();
}

}  // namespace kiri
