// SPDX-License-Identifier: MIT
#include "editor/tools/drawn_line.h"

#include <cmath>
#include <utility>

#include "core/geometry/rigid.h"
#include "editor/tools/tool_fields.h"
#include "editor/view/picking.h"

namespace kiri {
double handleReach(const PointerEvent& event) { return event.isTouch ? 22 : 10; }

std::optional<FacetId> paperUnder(const FoldedState& state, const PaneMap& map, Vec2 a, Vec2 b) {
  constexpr int kParts = 16;
  for (int away = 0; away <= kParts / 2; ++away) {
    for (const int at : {kParts / 2 + away, kParts / 2 - away}) {
      const Vec2 p = lerp(a, b, static_cast<double>(at) / kParts);
      if (const auto pick = pickPaper(state, map, p)) return pick->spot.facet;
    }
  }
  return std::nullopt;
}

std::optional<Vec2> carried(const FoldedState& state, const PaneMap& map, const Spot& spot,
                            FacetId frame) {
  if (spot.facet == frame || map.pane == Pane::Sheet) return spot.paper;
  if (state.layers.areCoplanar(spot.facet, frame))
    return state.poseOf(frame).pullBack(state.poseOf(spot.facet).apply(spot.paper));
  return map.onPlaneOf(state, frame, map.toPixels(state, spot));
}

bool LineHand::takeHandle(const PointerEvent& press, const Scope& scope) {
  const auto line = on(*scope.state);
  if (!line || press.pane != pane_ || start_) return false;
  const PaneMap& map = scope.map(pane_);
  const std::pair<Held, Vec2> handles[] = {{Held::To, line->to},
                                           {Held::From, line->from},
                                           {Held::Middle, lerp(line->from, line->to, 0.5)}};
  double nearest = handleReach(press);
  for (const auto& [handle, paper] : handles) {
    const double away = distance(map.toPixels(*scope.state, {line->facet, paper}), press.at);
    if (away >= nearest) continue;
    nearest = away;
    held_ = handle;
  }
  pressedAt_ = press.at;
  return held_ != Held::Nothing;
}

void LineHand::begin(const PointerEvent& press, const Scope& scope) {
  reset();
  pane_ = press.pane;
  held_ = Held::NewEnd;
  pressedAt_ = end_ = press.at;
  start_ = Start{press.at, std::nullopt, scope.snaps};
  if (const auto snapped = snapPoint(*scope.state, scope.map(pane_), press.at, scope.snaps)) {
    start_->caught = snapped->spot;
    caught_ = snapped->marks;
  }
}

bool LineHand::follow(const PointerEvent& event, const Scope& scope) {
  if (held_ == Held::Nothing || event.pane != pane_) return false;
  if (event.action != PointerAction::Move && event.action != PointerAction::Release) return false;
  const bool isRelease = event.action == PointerAction::Release;
  if (isRelease && event.button != PointerButton::Left) return false;
  if (held_ != Held::NewEnd) {
    if (distance(event.at, pressedAt_) >= kDragBegins || !isRelease) moveHandle(event.at, scope);
    if (isRelease) moveToPaperUnder(scope);
  } else {
    moveNewEnd(event.at, scope);
    if (isRelease && !isByClicks_ && distance(event.at, pressedAt_) < kDragBegins) {
      isByClicks_ = true;
      return true;
    }
  }
  if (!isRelease) return true;
  held_ = Held::Nothing;
  caught_.clear();
  start_.reset();
  return true;
}

bool LineHand::pointer(const PointerEvent& event, const Scope& scope) {
  if (event.action != PointerAction::Press) return follow(event, scope);
  if (event.button != PointerButton::Left) return false;
  if (held_ == Held::NewEnd && isByClicks_ && event.pane == pane_) return true;
  if (!takeHandle(event, scope)) begin(event, scope);
  return true;
}

void LineHand::reset() { *this = LineHand(); }

Vec2 LineHand::startPixels(const Scope& scope) const {
  const bool isKnown =
      start_->caught && start_->caught->facet.index < scope.state->pattern.facets.size();
  return isKnown ? scope.map(pane_).toPixels(*scope.state, *start_->caught) : start_->pixels;
}

void LineHand::moveNewEnd(Vec2 pixels, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(pane_);
  end_ = pixels;
  line_.reset();
  const Vec2 from = startPixels(scope);
  const auto frame = paperUnder(state, map, from, pixels);
  if (!frame) return;
  std::optional<Vec2> start;
  if (start_->caught && start_->caught->facet.index < state.pattern.facets.size())
    start = carried(state, map, *start_->caught, *frame);
  if (!start) {
    const auto snapped = snapPoint(state, map, start_->pixels, start_->snaps, *frame);
    if (!snapped) return;
    start = snapped->spot.paper;
  }
  const auto end = snapPoint(state, map, pixels, scope.snaps, *frame, *start);
  if (!end || distance(end->spot.paper, *start) <= state.tolerance().pick()) return;
  caught_ = end->marks;
  line_ = OnPaper{FacetName(state, *frame), *start, end->spot.paper};
}

void LineHand::moveHandle(Vec2 pixels, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const auto line = on(state);
  if (!line) return reset();
  std::optional<Vec2> from;
  if (held_ == Held::To) from = line->from;
  if (held_ == Held::From) from = line->to;
  const auto snapped = snapPoint(state, scope.map(pane_), pixels, scope.snaps, line->facet, from);
  if (!snapped) return;
  OnPaper next = *line_;
  const Vec2 p = snapped->spot.paper;
  if (held_ == Held::From) next.from = p;
  if (held_ == Held::To) next.to = p;
  if (held_ == Held::Middle) {
    const Vec2 by = p - lerp(line->from, line->to, 0.5);
    next.from = next.from + by;
    next.to = next.to + by;
  }
  if (distance(next.from, next.to) <= state.tolerance().pick()) return;
  line_ = next;
  caught_ = snapped->marks;
}

/// On the sheet a line belongs to the facet that holds its middle, wherever it was drawn first.
void LineHand::moveToPaperUnder(const Scope& scope) {
  if (!line_ || pane_ != Pane::Sheet) return;
  const auto facet = facetAt(scope.state->pattern, lerp(line_->from, line_->to, 0.5));
  if (facet) line_->facet = FacetName(*scope.state, *facet);
}

std::optional<FacetLine> LineHand::on(const FoldedState& state) const {
  if (!line_) return std::nullopt;
  const auto facet = line_->facet.in(state);
  if (!facet) return std::nullopt;
  return FacetLine{*facet, line_->from, line_->to};
}

std::optional<DrawnLine> LineHand::drawn() const {
  if (!line_) return std::nullopt;
  return DrawnLine{Frame::Paper, line_->from, line_->to, line_->facet.place()};
}

void LineHand::set(const FoldedState& state, const FacetLine& line, Pane pane) {
  reset();
  pane_ = pane;
  line_ = OnPaper{FacetName(state, line.facet), line.from, line.to};
}

MarkPlace LineHand::markPlace(const Scope& scope, FacetId frame, Vec2 paper) const {
  if (pane_ == Pane::Model) return scope.state->poseOf(frame).apply(paper);
  return PixelPlace{pane_, scope.sheet.toPixels(*scope.state, {frame, paper})};
}

void LineHand::addMarks(const Scope& scope, MarkRole role, Marks& marks) const {
  if (const auto line = on(*scope.state)) {
    const double reach = scope.state->tolerance().sheetSize();
    const Vec2 along = normalized(line->to - line->from) * reach;
    const auto at = [&](Vec2 paper) { return markPlace(scope, line->facet, paper); };
    marks.push_back(PathMark{MarkRole::Axis, {at(line->from - along), at(line->from)}});
    marks.push_back(PathMark{MarkRole::Axis, {at(line->to), at(line->to + along)}});
    marks.push_back(PathMark{role, {at(line->from), at(line->to)}});
    const std::pair<Held, Vec2> handles[] = {{Held::From, line->from},
                                             {Held::Middle, lerp(line->from, line->to, 0.5)},
                                             {Held::To, line->to}};
    for (const auto& [handle, paper] : handles) {
      const bool isHeld = handle == held_ || (handle == Held::To && held_ == Held::NewEnd);
      marks.push_back(PointMark{isHeld ? MarkRole::ActiveHandle : MarkRole::Handle, at(paper)});
    }
  } else if (start_) {
    marks.push_back(
        PathMark{MarkRole::Axis, {PixelPlace{pane_, startPixels(scope)}, PixelPlace{pane_, end_}}});
  }
  marks.insert(marks.end(), caught_.begin(), caught_.end());
}

void LineHand::addFields(std::vector<Field>& fields) const {
  if (!line_) return;
  const Vec2 way = line_->to - line_->from;
  fields.push_back(numberField(
      "length", {KIRI_TEXT("editor/tools", "Length"), {}}, length(way), {0, 100000, 1, "mm"},
      {KIRI_TEXT("editor/tools", "Length of the drawn line; its first end stays"), {}}));
  fields.push_back(numberField(
      "direction", {KIRI_TEXT("editor/tools", "Direction"), {}}, angleDegrees(way.x, way.y),
      {-180, 180, 15, "°"},
      {KIRI_TEXT("editor/tools", "Direction of the line on the sheet, counted from the x axis"),
       {}}));
}

bool LineHand::setField(const std::string& id, const FieldValue& value) {
  if (id != "length" && id != "direction") return false;
  if (!line_ || !std::isfinite(value.number)) return true;
  const Vec2 way = line_->to - line_->from;
  if (id == "length") {
    if (value.number > 0) line_->to = line_->from + way * (value.number / length(way));
  } else {
    const CosSin turn = cosSinDegrees(value.number);
    line_->to = line_->from + Vec2{turn.cos, turn.sin} * length(way);
  }
  return true;
}

}  // namespace kiri
