// SPDX-License-Identifier: MIT
#include "editor/tools/curve_hand.h"

#include <algorithm>
#include <cmath>

#include "editor/tools/curve_fit.h"
#include "editor/tools/curve_shape.h"
#include "editor/tools/drawn_line.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

/// How far a fitted curve may be from the stroke, pixels.
constexpr double kFitError = 1.5;
/// Points of a stroke nearer than this to the last one say nothing new, pixels.
constexpr double kStrokeStep = 2;

/// The facet that is seen at a pixel, or one whose picture is nearest to it.
std::optional<FacetId> nearestPaper(const Scope& scope, Pane pane, Vec2 pixels) {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(pane);
  if (const auto pick = pickPaper(state, map, pixels)) return pick->spot.facet;
  std::optional<FacetId> best;
  double nearest = HUGE_VAL;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    for (const EdgeUse use : state.pattern[FacetId(f)].border) {
      const Arc arc = arcOf(state.pattern, use);
      const Arc seen = Arc::line(map.toPixels(state, {FacetId(f), arc.start}),
                                 map.toPixels(state, {FacetId(f), arc.end}));
      const double away = nearestOn(seen, pixels).distance;
      if (!(away < nearest)) continue;
      nearest = away;
      best = FacetId(f);
    }
  }
  return best;
}

}  // namespace

MarkPlace placeInPane(const Scope& scope, Pane pane, const Spot& spot) {
  if (pane == Pane::Model) return scope.state->poseOf(spot.facet).apply(spot.paper);
  return PixelPlace{pane, scope.sheet.toPixels(*scope.state, spot)};
}

std::optional<FacetId> CurveHand::frameIn(const FoldedState& state) const {
  return frame_ ? frame_->in(state) : std::nullopt;
}

Vec2 CurveHand::pixelsOf(Vec2 paper, const Scope& scope) const {
  const auto frame = frameIn(*scope.state);
  return frame ? scope.map(pane_).toPixels(*scope.state, {*frame, paper}) : Vec2{};
}

std::optional<Vec2> CurveHand::snapped(Vec2 pixels, const Scope& scope, std::optional<Vec2> from) {
  caught_.clear();
  const auto frame = frameIn(*scope.state);
  if (!frame) return std::nullopt;
  const auto found = snapPoint(*scope.state, scope.map(pane_), pixels, scope.snaps, *frame, from);
  if (!found) return std::nullopt;
  caught_ = found->marks;
  return found->spot.paper;
}

std::optional<std::size_t> CurveHand::controlNear(Vec2 pixels, double reach,
                                                  const Scope& scope) const {
  std::optional<std::size_t> best;
  double nearest = reach;
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const double away = distance(pixelsOf(controls_[i], scope), pixels);
    if (away >= nearest) continue;
    nearest = away;
    best = i;
  }
  return best;
}

/// The parameter of the curve's point under the pointer; arcs count 1 each.
std::optional<double> CurveHand::curveNear(Vec2 pixels, double reach, const Scope& scope) const {
  constexpr int kPerArc = 32;
  const std::vector<Vec2> points = polyline(arcs(), kPerArc);
  std::optional<double> best;
  double nearest = reach;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = distance(pixelsOf(points[i], scope), pixels);
    if (away >= nearest) continue;
    nearest = away;
    best = static_cast<double>(i) / kPerArc;
  }
  return best;
}

// Drawing.

bool CurveHand::press(const PointerEvent& event, const Scope& scope) {
  if (phase_ == Phase::Empty) return begin(event, scope);
  if (!frameIn(*scope.state)) {
    reset();
    return begin(event, scope);
  }
  if (event.pane != pane_) return phase_ == Phase::Drawing;
  pressedAt_ = lastAt_ = event.at;
  const double reach = handleReach(event);
  const auto control = controlNear(event.at, reach, scope);
  if (phase_ == Phase::Drawing && control == std::size_t{0} &&
      controls_.size() >= leastControls(true)) {
    isClosed_ = true;
    finish(scope);
    return true;
  }
  if (control) {
    held_ = active_ = control;
    return true;
  }
  if (phase_ == Phase::Resting) return curveNear(event.at, reach, scope).has_value();
  addControl(event, scope);
  return true;
}

bool CurveHand::begin(const PointerEvent& event, const Scope& scope) {
  const auto facet = nearestPaper(scope, event.pane, event.at);
  if (!facet) return false;
  reset();
  pane_ = event.pane;
  frame_.emplace(*scope.state, *facet);
  hasMetPaper_ = pickPaper(*scope.state, scope.map(pane_), event.at).has_value();
  pressedAt_ = lastAt_ = event.at;
  phase_ = Phase::Drawing;
  addControl(event, scope);
  if (controls_.empty()) reset();  // the plane of the paper is seen edge-on
  return isBusy();
}

void CurveHand::addControl(const PointerEvent& event, const Scope& scope) {
  meetPaper(event.at, scope);
  std::optional<Vec2> from;
  if (!controls_.empty()) from = controls_.back();
  const auto place = snapped(event.at, scope, from);
  next_.reset();
  if (!place) return;
  controls_.push_back(*place);
  held_ = active_ = controls_.size() - 1;
}

/// Before the curve has met paper it may have been put into a plane that it has nothing to do with.
void CurveHand::meetPaper(Vec2 pixels, const Scope& scope) {
  if (hasMetPaper_) return;
  const auto pick = pickPaper(*scope.state, scope.map(pane_), pixels);
  const auto frame = frameIn(*scope.state);
  if (!pick || !frame) return;
  std::vector<Vec2> moved;
  for (const Vec2 control : controls_) {
    const auto here = carried(*scope.state, scope.map(pane_), {*frame, control}, pick->spot.facet);
    if (!here) return;
    moved.push_back(*here);
  }
  controls_ = std::move(moved);
  frame_.emplace(*scope.state, pick->spot.facet);
  hasMetPaper_ = true;
}

bool CurveHand::follow(const PointerEvent& event, const Scope& scope) {
  if (phase_ == Phase::Empty || !frameIn(*scope.state)) return false;
  switch (event.action) {
    case PointerAction::Leave:
      next_.reset();
      hovered_.reset();
      if (!isMoving()) caught_.clear();
      return false;
    case PointerAction::DoubleClick:
      if (event.pane != pane_ || event.button != PointerButton::Left) return false;
      if (phase_ == Phase::Drawing) {
        finish(scope);
        return true;
      }
      return insertAt(event.at, handleReach(event), scope);
    case PointerAction::Move:
      if (event.pane != pane_) return false;
      lastAt_ = event.at;
      if (isStroke_) {
        goOnStroke(event, scope);
      } else if (held_) {
        moveHeld(event, scope);
      } else {
        hover(event, scope);
        return phase_ == Phase::Drawing;
      }
      return true;
    case PointerAction::Release: {
      if (event.button != PointerButton::Left || !isMoving()) return false;
      release(event, scope);
      return true;
    }
    case PointerAction::Press:
      break;
  }
  return false;
}

void CurveHand::moveHeld(const PointerEvent& event, const Scope& scope) {
  const bool isFar = distance(event.at, pressedAt_) >= kDragBegins;
  if (phase_ == Phase::Drawing && controls_.size() == 1 && isFar) {
    isStroke_ = true;
    held_.reset();
    active_.reset();
    caught_.clear();
    stroke_ = controls_;
    goOnStroke(event, scope);
    return;
  }
  if (!isFar && phase_ == Phase::Resting) return;
  std::optional<Vec2> from;
  if (*held_ > 0) from = controls_[*held_ - 1];
  const auto place = snapped(event.at, scope, from);
  if (place) controls_[*held_] = *place;
}

void CurveHand::hover(const PointerEvent& event, const Scope& scope) {
  hovered_ = controlNear(event.at, handleReach(event), scope);
  next_.reset();
  if (phase_ != Phase::Drawing || hovered_) return;
  next_ = snapped(event.at, scope, controls_.back());
}

void CurveHand::goOnStroke(const PointerEvent& event, const Scope& scope) {
  const PaneMap& map = scope.map(pane_);
  if (!stroke_.empty() && distance(pixelsOf(stroke_.back(), scope), event.at) < kStrokeStep) return;
  const auto before = frameIn(*scope.state);
  meetPaper(event.at, scope);
  const auto frame = frameIn(*scope.state);
  if (!frame || !before) return;
  if (*frame != *before) {  // the stroke is a list of controls, too
    for (Vec2& point : stroke_) {
      if (const auto here = carried(*scope.state, map, {*before, point}, *frame)) point = *here;
    }
  }
  const auto place = map.onPlaneOf(*scope.state, *frame, event.at);
  if (!place) return;
  stroke_.push_back(*place);
  controls_ = fitCurve(stroke_, false, kFitError / map.pixelsPerMm).controls;
  if (controls_.empty()) controls_ = {stroke_.front()};
}

void CurveHand::release(const PointerEvent& event, const Scope& scope) {
  held_.reset();
  caught_.clear();
  if (!isStroke_) return;
  isStroke_ = false;
  const PaneMap& map = scope.map(pane_);
  const Vec2 start = pixelsOf(stroke_.front(), scope);
  double farthest = 0;
  for (const Vec2 p : stroke_) farthest = std::max(farthest, distance(pixelsOf(p, scope), start));
  const double reach = handleReach(event);
  isClosed_ = distance(event.at, start) <= reach && farthest > 4 * reach;
  if (isClosed_) {
    // The end of the stroke overlaps its start a little; a closed curve has one of both.
    while (stroke_.size() > 8 && distance(pixelsOf(stroke_.back(), scope), start) <= reach)
      stroke_.pop_back();
  }
  controls_ = fitCurve(stroke_, isClosed_, kFitError / map.pixelsPerMm).controls;
  stroke_.clear();
  if (controls_.size() < leastControls(isClosed_)) return reset();
  finish(scope);
}

void CurveHand::finish(const Scope& scope) {
  const double near = scope.state->tolerance().pick();
  const auto isSame = [&](Vec2 a, Vec2 b) { return distance(a, b) <= near; };
  controls_.erase(std::unique(controls_.begin(), controls_.end(), isSame), controls_.end());
  isStroke_ = false;
  stroke_.clear();
  held_.reset();
  hovered_.reset();
  next_.reset();
  caught_.clear();
  if (controls_.size() < 2) {
    reset();
    return;
  }
  if (controls_.size() < leastControls(true)) isClosed_ = false;
  if (!isClosed_) controls_ = elevated(controls_);
  active_.reset();
  phase_ = Phase::Resting;
  for (const Vec2 p : polyline(arcs(), 4)) meetPaper(pixelsOf(p, scope), scope);
}

std::vector<Vec2> CurveHand::shape() const {
  std::vector<Vec2> all = controls_;
  if (next_ && phase_ == Phase::Drawing) all.push_back(*next_);
  return isClosed_ ? all : elevated(all);
}

std::vector<Arc> CurveHand::arcs() const { return splineOf(shape(), isClosed_); }

std::optional<CurveCutStep> CurveHand::cut(const FoldedState& state) const {
  const auto frame = frameIn(state);
  CurveCutStep step;
  step.controls = shape();
  if (!frame || step.controls.size() < leastControls(isClosed_)) return std::nullopt;
  const auto isAtStart = [&](Vec2 p) {
    return distance(p, step.controls.front()) <= state.tolerance().pick();
  };
  if (std::all_of(step.controls.begin(), step.controls.end(), isAtStart)) return std::nullopt;
  step.frame = Frame::Paper;
  step.facet = frame_->place();
  step.isClosed = isClosed_;
  return step;
}

std::optional<PlaneTrace> CurveHand::trace(const FoldedState& state) const {
  constexpr int kPerArc = 8;
  const auto frame = frameIn(state);
  if (!frame || !cut(state)) return std::nullopt;
  return PlaneTrace{pane_, *frame, polyline(arcs(), kPerArc)};
}

void CurveHand::addMarks(const Scope& scope, Marks& marks) const {
  constexpr int kPerArc = 16;
  const auto frame = frameIn(*scope.state);
  if (!frame) return;
  const auto at = [&](Vec2 paper) { return placeInPane(scope, pane_, {*frame, paper}); };
  const auto path = [&](MarkRole role, const std::vector<Vec2>& points, bool isClosed) {
    PathMark mark{role, {}, isClosed, false};
    for (const Vec2 p : points) mark.places.push_back(at(p));
    if (mark.places.size() > 1) marks.push_back(std::move(mark));
  };
  if (!isStroke_) path(MarkRole::Curve, shape(), isClosed_);
  path(MarkRole::Line, polyline(arcs(), kPerArc), false);
  if (isStroke_) return;
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const bool isActive = i == active_ || i == held_ || i == hovered_;
    marks.push_back(
        PointMark{isActive ? MarkRole::ActiveHandle : MarkRole::Handle, at(controls_[i])});
  }
  marks.insert(marks.end(), caught_.begin(), caught_.end());
}

}  // namespace kiri
