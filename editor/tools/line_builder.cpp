// SPDX-License-Identifier: MIT
#include "editor/tools/line_builder.h"

#include <algorithm>

#include "editor/snap/snap.h"
#include "editor/tools/drawn_line.h"
#include "editor/view/picking.h"

namespace kiri {

std::vector<Phrase> constructionNames() {
  return {{KIRI_TEXT("editor/tools", "By hand"), {}},
          {KIRI_TEXT("editor/tools", "Through two points"), {}},
          {KIRI_TEXT("editor/tools", "Point onto point"), {}},
          {KIRI_TEXT("editor/tools", "Line onto line"), {}},
          {KIRI_TEXT("editor/tools", "Through a point, square to a line"), {}},
          {KIRI_TEXT("editor/tools", "Point onto line, through a point"), {}},
          {KIRI_TEXT("editor/tools", "Two points onto two lines"), {}},
          {KIRI_TEXT("editor/tools", "Point onto line, square to a line"), {}},
          {KIRI_TEXT("editor/tools", "Bisector of a corner"), {}},
          {KIRI_TEXT("editor/tools", "Mirrored in a line"), {}},
          {KIRI_TEXT("editor/tools", "Onto the nearest edge"), {}}};
}

std::vector<LineBuilder::Want> LineBuilder::wants() const {
  constexpr Want kP = Want::Point;
  constexpr Want kL = Want::Line;
  switch (kind_) {
    case Construction::ByHand:
      return {};
    case Construction::ThroughPoints:
    case Construction::PointOntoPoint:
      return {kP, kP};
    case Construction::LineOntoLine:
      return {kL, kL};
    case Construction::SquareThrough:
      return {kP, kL};
    case Construction::PointOntoLine:
      return {kP, kL, kP};
    case Construction::PointsOntoLines:
      return {kP, kL, kP, kL};
    case Construction::PointSquareTo:
      return {kP, kL, kL};
    case Construction::Bisector:
      return {kP, kP, kP};
    case Construction::Mirror:
      return hasMirror_ ? std::vector<Want>{kL} : std::vector<Want>{kL, kL};
    case Construction::Project:
      return {kL};
  }
  return {};
}

void LineBuilder::begin(Construction kind) {
  *this = LineBuilder();
  kind_ = kind;
}

std::optional<Line2> LineBuilder::lineUnder(const PointerEvent& event, const Scope& scope,
                                            FacetId& facet) const {
  const FoldedState& state = *scope.state;
  const auto pick = pickEdge(state, scope.map(event.pane), event.at, 2 * handleReach(event));
  if (!pick || state.pattern[pick->edge].isCurved()) return std::nullopt;
  const Edge& edge = state.pattern[pick->edge];
  facet = pick->spot.facet;
  return Line2{state.pattern[edge.from], state.pattern[edge.to]};
}

bool LineBuilder::pick(const PointerEvent& event, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(event.pane);
  if (kind_ == Construction::Mirror) hasMirror_ = scope.selection.lastLine().has_value();
  if (isComplete()) {
    picks_.clear();
    frame_.reset();
  }
  if (wants().empty()) return false;
  Pick pick;
  FacetId facet;
  if (wants()[picks_.size()] == Want::Point) {
    const auto snapped = snapPoint(state, map, event.at, scope.snaps);
    if (!snapped) return false;
    facet = snapped->spot.facet;
    pick = {snapped->spot.paper, {}, false};
  } else {
    const auto line = lineUnder(event, scope, facet);
    if (!line) return false;
    pick = {line->from, line->to, true};
  }
  if (!frame_) frame_ = FacetName(state, facet);
  const auto frame = frame_->in(state);
  if (!frame) return false;
  const auto from = carried(state, map, {facet, pick.from}, *frame);
  const auto to = pick.isLine ? carried(state, map, {facet, pick.to}, *frame) : from;
  if (!from || !to) return false;
  picks_.push_back({*from, *to, pick.isLine});
  return true;
}

void LineBuilder::give(const FoldedState& state, const FacetLine& line) {
  picks_ = {{line.from, line.to, true}};
  frame_ = FacetName(state, line.facet);
}

void LineBuilder::dropLast() {
  if (!picks_.empty()) picks_.pop_back();
  if (picks_.empty()) frame_.reset();
}

std::optional<Line2> LineBuilder::mirrorLine(const Scope& scope, FacetId frame) const {
  if (picks_.size() > 1) return Line2{picks_[1].from, picks_[1].to};
  const auto selected = scope.selection.lastLine();
  if (!selected) return std::nullopt;
  const FoldedState& state = *scope.state;
  const auto facet = facetAt(state.pattern, selected->place);
  if (!facet || !state.layers.areCoplanar(*facet, frame)) return std::nullopt;
  const FacetLine here = lineOn(state, {*facet, selected->from, selected->to}, frame);
  return Line2{here.from, here.to};
}

std::optional<Line2> LineBuilder::nearestEdge(const Scope& scope, FacetId frame,
                                              const Line2& line) const {
  const FoldedState& state = *scope.state;
  std::optional<Line2> best;
  double nearest = 0;
  for (const FacetId f : state.layers.sets()[state.layers.setOf(frame)].upward) {
    for (const EdgeUse use : state.pattern[f].border) {
      if (state.pattern[use.edge].isCurved()) continue;
      const Arc edge = arcOf(state.pattern, use);
      const FacetLine here = lineOn(state, {f, edge.start, edge.end}, frame);
      const Arc arc = Arc::line(here.from, here.to);
      double away = 0;
      for (const Vec2 p : {line.from, lerp(line.from, line.to, 0.5), line.to})
        away += nearestOn(arc, p).distance;
      if (best && away >= nearest) continue;
      nearest = away;
      best = Line2{here.from, here.to};
    }
  }
  return best;
}

std::vector<Line2> LineBuilder::linesIn(const Scope& scope, FacetId frame) const {
  const double near = scope.state->tolerance().match();
  const auto point = [&](std::size_t i) { return picks_[i].from; };
  const auto line = [&](std::size_t i) { return Line2{picks_[i].from, picks_[i].to}; };
  switch (kind_) {
    case Construction::ByHand:
      return {};
    case Construction::ThroughPoints:
      return throughPoints(point(0), point(1), near);
    case Construction::PointOntoPoint:
      return pointOntoPoint(point(0), point(1), near);
    case Construction::LineOntoLine:
      return lineOntoLine(line(0), line(1), near);
    case Construction::SquareThrough:
      return squareThrough(point(0), line(1), near);
    case Construction::PointOntoLine:
      return pointOntoLineThrough(point(0), line(1), point(2), near);
    case Construction::PointsOntoLines:
      return pointsOntoLines(point(0), line(1), point(2), line(3), near);
    case Construction::PointSquareTo:
      return pointOntoLineSquareTo(point(0), line(1), line(2), near);
    case Construction::Bisector:
      return bisectorOf(point(0), point(1), point(2), near);
    case Construction::Mirror:
      if (const auto mirror = mirrorLine(scope, frame)) return {mirrored(line(0), *mirror)};
      return {};
    case Construction::Project:
      if (const auto edge = nearestEdge(scope, frame, line(0)))
        return {{projectedOnto(line(0).from, *edge), projectedOnto(line(0).to, *edge)}};
      return {};
  }
  return {};
}

std::optional<LineBuilder::Built> LineBuilder::build(const Scope& scope) const {
  if (kind_ == Construction::ByHand || picks_.empty() || !frame_) return std::nullopt;
  const auto frame = frame_->in(*scope.state);
  const bool isMirrored = kind_ == Construction::Mirror && scope.selection.lastLine();
  if (!frame || (!isComplete() && !isMirrored)) return std::nullopt;
  const bool hasEnds = kind_ == Construction::Mirror || kind_ == Construction::Project;
  Built built{*frame, linesIn(scope, *frame), !hasEnds};
  const double least = scope.state->tolerance().pick();
  std::erase_if(built.lines,
                [least](const Line2& line) { return distance(line.from, line.to) <= least; });
  if (!built.isEndless) return built;
  // Long enough to cross all paper, about the place nearest to what was picked.
  Vec2 middle;
  for (const Pick& pick : picks_)
    middle = middle + (pick.from + (pick.isLine ? pick.to : pick.from)) / 2;
  middle = middle / static_cast<double>(picks_.size());
  for (Line2& line : built.lines) {
    const Vec2 foot = projectedOnto(middle, line);
    const Vec2 along = normalized(line.to - line.from) * scope.state->tolerance().sheetSize();
    line = {foot - along, foot + along};
  }
  return built;
}

Phrase LineBuilder::hint() const {
  if (kind_ == Construction::Project)
    return {KIRI_TEXT("editor/tools", "Draw a line; it is laid onto the edge nearest to it"), {}};
  const std::vector<Want> wanted = wants();
  if (picks_.size() >= wanted.size())
    return {KIRI_TEXT("editor/tools", "No line does this; pick again"), {}};
  const std::vector<std::string> counts = {std::to_string(picks_.size() + 1),
                                           std::to_string(wanted.size())};
  if (wanted[picks_.size()] == Want::Point)
    return {KIRI_TEXT("editor/tools", "Click a point (%1 of %2)"), counts};
  return {KIRI_TEXT("editor/tools", "Click an edge or a crease (%1 of %2)"), counts};
}

void LineBuilder::hover(const PointerEvent& event, const Scope& scope) {
  hovered_.clear();
  const std::vector<Want> wanted = wants();
  if (wanted.empty() || kind_ == Construction::Project) return;
  const std::size_t next = picks_.size() < wanted.size() ? picks_.size() : 0;
  if (wanted[next] == Want::Point) {
    const auto snapped = snapPoint(*scope.state, scope.map(event.pane), event.at, scope.snaps);
    if (snapped) hovered_ = snapped->marks;
    return;
  }
  FacetId facet;
  if (const auto line = lineUnder(event, scope, facet)) {
    hovered_.push_back(PathMark{
        MarkRole::Hovered, {Spot{facet, line->from}, Spot{facet, line->to}}, false, false});
  }
}

void LineBuilder::addMarks(const Scope& scope, Marks& marks) const {
  const auto frame = frame_ ? frame_->in(*scope.state) : std::nullopt;
  if (frame) {
    for (const Pick& pick : picks_) {
      const Spot from{*frame, pick.from};
      if (pick.isLine) {
        marks.push_back(PathMark{MarkRole::Selected, {from, Spot{*frame, pick.to}}, false, false});
      } else {
        marks.push_back(PointMark{MarkRole::Selected, from});
      }
    }
  }
  marks.insert(marks.end(), hovered_.begin(), hovered_.end());
}

}  // namespace kiri
