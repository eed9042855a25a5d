// SPDX-License-Identifier: MIT
#include "editor/tools/measure_tool.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "editor/tools/drawn_line.h"
#include "editor/tools/tool_fields.h"
#include "editor/tools/tool_marks.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

/// Angle at `corner` between the ways to a and b, degrees.
double angleAt(Vec3 a, Vec3 corner, Vec3 b) {
  return angleDegrees(dot(a - corner, b - corner), length(cross(a - corner, b - corner)));
}

Vec3 inSpace(const FoldedState& state, const Spot& spot) {
  return state.poseOf(spot.facet).apply(spot.paper);
}

/// A number as it is told: to a hundredth.
std::string told(double number) { return text(std::round(number * 100) / 100); }

/// The edge on which a place lies.
std::optional<EdgeId> edgeThrough(const FoldedState& state, Vec2 place) {
  std::optional<EdgeId> best;
  double nearest = state.tolerance().pick();
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const double away = nearestOn(arcOf(state.pattern, EdgeId(e)), place).distance;
    if (away >= nearest) continue;
    nearest = away;
    best = EdgeId(e);
  }
  return best;
}

}  // namespace

void MeasureTool::reset() {
  points_.clear();
  next_.reset();
  edge_.reset();
  facet_.reset();
  caught_.clear();
}

Reaction MeasureTool::pointer(const PointerEvent& event, const Scope& scope) {
  if (event.action == PointerAction::Press && event.button == PointerButton::Left) {
    pick(event, scope);
    return Reaction::handled();
  }
  if (event.action == PointerAction::Leave) {
    caught_.clear();
    next_.reset();
  }
  if (event.action != PointerAction::Move) return Reaction::ignored();
  caught_.clear();
  next_.reset();
  if (what_ != What::Distance && what_ != What::Angle) return Reaction::ignored();
  const auto snapped = snapPoint(*scope.state, scope.map(event.pane), event.at, scope.snaps);
  if (!snapped) return Reaction::ignored();
  caught_ = snapped->marks;
  if (!points_.empty() && points_.size() < needed())
    next_ = Point{FacetName(*scope.state, snapped->spot.facet), snapped->spot.paper};
  return Reaction::ignored();
}

void MeasureTool::pick(const PointerEvent& event, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(event.pane);
  if (what_ == What::Facet) {
    const auto found = pickPaper(state, map, event.at);
    reset();
    if (found) facet_ = FacetName(state, found->spot.facet);
    return;
  }
  if (what_ == What::Edge) {
    const auto found = pickEdge(state, map, event.at, handleReach(event));
    reset();
    if (!found) return;
    const Arc arc = arcOf(state.pattern, found->edge);
    edge_ = pointAt(arc, nearestOn(arc, found->spot.paper).t);
    return;
  }
  const auto snapped = snapPoint(state, map, event.at, scope.snaps);
  if (points_.size() >= needed()) points_.clear();
  next_.reset();
  if (snapped) points_.push_back({FacetName(state, snapped->spot.facet), snapped->spot.paper});
}

Reaction MeasureTool::key(const KeyEvent& event, const Scope&) {
  if (!event.isPress || !isBusy()) return Reaction::ignored();
  if (event.key == Key::Backspace && !points_.empty()) {
    points_.pop_back();
    return Reaction::handled();
  }
  if (event.key != Key::Escape) return Reaction::ignored();
  reset();
  return Reaction::handled();
}

std::vector<Spot> MeasureTool::spots(const FoldedState& state, bool withNext) const {
  std::vector<Spot> spots;
  std::vector<Point> points = points_;
  if (withNext && next_) points.push_back(*next_);
  for (const Point& point : points) {
    if (const auto facet = point.facet.in(state)) spots.push_back({*facet, point.paper});
  }
  return spots;
}

void MeasureTool::addPoints(const Scope& scope, Marks& marks) const {
  const FoldedState& state = *scope.state;
  const std::vector<Spot> at = spots(state, true);
  for (const Spot& spot : at) marks.push_back(PointMark{MarkRole::Measure, spot});
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    marks.push_back(PathMark{MarkRole::Measure, {at[i], at[i + 1]}, false, false});
  }
  if (what_ == What::Distance && at.size() == 2) {
    const double onSheet = distance(at[0].paper, at[1].paper);
    const double through = distance(inSpace(state, at[0]), inSpace(state, at[1]));
    marks.push_back(TextMark{MarkRole::Measure,
                             at[1],
                             {KIRI_TEXT("editor/tools", "%1 mm on the sheet, %2 mm in space"),
                              {told(onSheet), told(through)}}});
  }
  if (what_ == What::Angle && at.size() == 3) {
    const double angle =
        angleAt(inSpace(state, at[0]), inSpace(state, at[1]), inSpace(state, at[2]));
    marks.push_back(
        TextMark{MarkRole::Measure, at[1], {KIRI_TEXT("editor/tools", "%1°"), {told(angle)}}});
  }
}

void MeasureTool::addThings(const Scope& scope, Marks& marks) const {
  const FoldedState& state = *scope.state;
  if (edge_) {
    if (const auto edge = edgeThrough(state, *edge_)) {
      const Arc arc = arcOf(state.pattern, *edge);
      const FacetId facet = state.pattern[*edge].left.isValid() ? state.pattern[*edge].left
                                                                : state.pattern[*edge].right;
      PathMark path{MarkRole::Measure, {}, false, false};
      const int pieces = arc.isCurved ? 12 : 1;
      for (int i = 0; i <= pieces; ++i)
        path.places.push_back(Spot{facet, pointAt(arc, static_cast<double>(i) / pieces)});
      marks.push_back(path);
      marks.push_back(TextMark{MarkRole::Measure,
                               Spot{facet, *edge_},
                               {KIRI_TEXT("editor/tools", "%1 mm"),
                                {told(lengthOf(arc, state.tolerance().flattening()))}}});
    }
  }
  if (!facet_) return;
  const auto facet = facet_->in(state);
  if (!facet) return;
  marks.push_back(outlineOf(state, *facet, MarkRole::Measure));
  marks.push_back(TextMark{
      MarkRole::Measure,
      Spot{*facet, facet_->place()},
      {KIRI_TEXT("editor/tools", "%1 mm²"), {told(areaOf(regionOf(state.pattern, *facet)))}}});
}

Marks MeasureTool::marks(const Scope& scope) const {
  Marks marks;
  addPoints(scope, marks);
  addThings(scope, marks);
  marks.insert(marks.end(), caught_.begin(), caught_.end());
  return marks;
}

std::vector<Field> MeasureTool::results(const FoldedState& state) const {
  std::vector<Field> shown;
  const std::vector<Spot> at = spots(state, false);
  if (what_ == What::Distance && at.size() == 2) {
    shown.push_back(shownNumber("paper", {KIRI_TEXT("editor/tools", "On the sheet"), {}},
                                distance(at[0].paper, at[1].paper), "mm"));
    shown.push_back(shownNumber("space", {KIRI_TEXT("editor/tools", "In space"), {}},
                                distance(inSpace(state, at[0]), inSpace(state, at[1])), "mm"));
  }
  if (what_ == What::Angle && at.size() == 3) {
    shown.push_back(shownNumber(
        "angle", {KIRI_TEXT("editor/tools", "Angle"), {}},
        angleAt(inSpace(state, at[0]), inSpace(state, at[1]), inSpace(state, at[2])), "°"));
  }
  const auto edge = edge_ ? edgeThrough(state, *edge_) : std::nullopt;
  if (edge) {
    shown.push_back(
        shownNumber("length", {KIRI_TEXT("editor/tools", "Length"), {}},
                    lengthOf(arcOf(state.pattern, *edge), state.tolerance().flattening()), "mm"));
    if (state.pattern[*edge].kind == EdgeKind::Hinge) {
      shown.push_back(shownNumber("hinge", {KIRI_TEXT("editor/tools", "Fold angle"), {}},
                                  state.pattern[*edge].angle, "°"));
    }
  }
  const auto facet = facet_ ? facet_->in(state) : std::nullopt;
  if (facet) {
    shown.push_back(shownNumber("area", {KIRI_TEXT("editor/tools", "Area"), {}},
                                areaOf(regionOf(state.pattern, *facet)), "mm²"));
  }
  return shown;
}

std::vector<Field> MeasureTool::fields(const Scope& scope) const {
  std::vector<Field> fields = {choiceField("what", {KIRI_TEXT("editor/tools", "Measure"), {}},
                                           {{KIRI_TEXT("editor/tools", "Distance"), {}},
                                            {KIRI_TEXT("editor/tools", "Angle"), {}},
                                            {KIRI_TEXT("editor/tools", "Edge"), {}},
                                            {KIRI_TEXT("editor/tools", "Facet"), {}}},
                                           static_cast<int>(what_), {})};
  const std::vector<Field> found = results(*scope.state);
  fields.insert(fields.end(), found.begin(), found.end());
  return fields;
}

Reaction MeasureTool::setField(const std::string& id, const FieldValue& value, const Scope&) {
  if (id != "what" || !std::isfinite(value.number)) return Reaction::ignored();
  what_ = static_cast<What>(static_cast<int>(std::clamp(value.number, 0.0, 3.0)));
  reset();
  return Reaction::handled();
}

Phrase MeasureTool::hint(const Scope&) const {
  switch (what_) {
    case What::Distance:
      return points_.size() == 1
                 ? Phrase{KIRI_TEXT("editor/tools", "Click the second point"), {}}
                 : Phrase{KIRI_TEXT("editor/tools", "Click two points of the paper"), {}};
    case What::Angle:
      return {KIRI_TEXT("editor/tools", "Click three points: the angle is at the second"), {}};
    case What::Edge:
      return {KIRI_TEXT("editor/tools", "Click an edge or a crease"), {}};
    case What::Facet:
      return {KIRI_TEXT("editor/tools", "Click a facet"), {}};
  }
  return {};
}

}  // namespace kiri
