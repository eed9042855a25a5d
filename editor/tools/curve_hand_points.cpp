// Moving, adding, removing and typing the points of a curve.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/model/locate.h"
#include "editor/tools/curve_fit.h"
#include "editor/tools/curve_hand.h"
#include "editor/tools/curve_shape.h"
#include "editor/tools/drawn_line.h"

namespace kiri {

bool CurveHand::insertAt(Vec2 pixels, double reach, const Scope& scope) {
  const auto at = curveNear(pixels, reach, scope);
  if (!at || controlNear(pixels, reach, scope)) return false;
  controls_ = withControlAt(controls_, isClosed_, *at);
  active_ = controlNear(pixels, HUGE_VAL, scope);
  held_.reset();
  return true;
}

bool CurveHand::remove(const Scope& scope) {
  hovered_ = controlNear(lastAt_, handleReach(PointerEvent{}), scope);
  const auto which = hovered_ ? hovered_ : active_;
  if (!which || controls_.size() <= leastControls(isClosed_)) return false;
  controls_.erase(controls_.begin() + static_cast<std::ptrdiff_t>(*which));
  held_.reset();
  hovered_.reset();
  active_.reset();
  return true;
}

void CurveHand::nudge(const KeyEvent& event, const Scope& scope) {
  const double step = event.modifiers.shift ? 10 : event.modifiers.control ? 1.0 / 10 : 1;
  Vec2 by;
  if (event.key == Key::Left) by.x = -step;
  if (event.key == Key::Right) by.x = step;
  if (event.key == Key::Down) by.y = -step;
  if (event.key == Key::Up) by.y = step;
  Vec2& control = controls_[*active_];
  control = fromShown(shown(control, *scope.state) + by, *scope.state);
}

bool CurveHand::key(const KeyEvent& event, const Scope& scope) {
  if (phase_ == Phase::Empty || !frameIn(*scope.state)) return false;
  switch (event.key) {
    case Key::Enter:
      if (phase_ != Phase::Drawing || isMoving()) return false;
      finish(scope);
      return true;
    case Key::Backspace:
      if (phase_ == Phase::Drawing && !isMoving()) {
        controls_.pop_back();
        active_.reset();
        hovered_.reset();
        if (controls_.empty()) reset();
        return true;
      }
      return !isMoving() && remove(scope);
    case Key::Delete:
      return !isMoving() && phase_ == Phase::Resting && remove(scope);
    case Key::Tab:
      if (isStroke_) return false;
      active_ = active_ ? (*active_ + 1) % controls_.size() : 0;
      return true;
    case Key::Left:
    case Key::Right:
    case Key::Up:
    case Key::Down:
      if (!active_ || isMoving()) return false;
      nudge(event, scope);
      return true;
    case Key::Insert:
    case Key::Character:
      return (event.key == Key::Insert || event.character == '+') && phase_ == Phase::Resting &&
             !isMoving() && insertAt(lastAt_, handleReach(PointerEvent{}), scope);
    default:
      return false;
  }
}

// Numbers.

bool CurveHand::isInModelFrame(const FoldedState& state) const {
  constexpr double kUpright = 1.0 / 1024;
  const auto frame = frameIn(state);
  return pane_ == Pane::Model && frame && std::abs(state.poseOf(*frame).normal().z) > kUpright;
}

Vec2 CurveHand::shown(Vec2 paper, const FoldedState& state) const {
  if (!isInModelFrame(state)) return paper;
  return flatten(state.poseOf(*frameIn(state)).apply(paper));
}

Vec2 CurveHand::fromShown(Vec2 typed, const FoldedState& state) const {
  return isInModelFrame(state) ? onPlaneOf(state, *frameIn(state), typed) : typed;
}

void CurveHand::addFields(const Scope& scope, std::vector<Field>& fields) const {
  constexpr double kMost = 1000000;
  if (active_ && !isStroke_ && frameIn(*scope.state)) {
    const Vec2 at = shown(controls_[*active_], *scope.state);
    Field x;
    x.id = "x";
    x.label = {"x", {}};
    x.value = at.x;
    x.least = -kMost;
    x.most = kMost;
    x.unit = "mm";
    x.help = {KIRI_TEXT("editor/tools", "Place of the active control point"), {}};
    Field y = x;
    y.id = "y";
    y.label = {"y", {}};
    y.value = at.y;
    fields.push_back(x);
    fields.push_back(y);
  }
  if (phase_ == Phase::Empty || isStroke_) return;
  Field closed;
  closed.id = "closed";
  closed.label = {KIRI_TEXT("editor/tools", "Closed"), {}};
  closed.kind = Field::Kind::Switch;
  closed.value = isClosed_ ? 1 : 0;
  closed.isEnabled = isClosed_ || controls_.size() >= leastControls(true);
  closed.help = {KIRI_TEXT("editor/tools", "The curve comes back to where it starts"), {}};
  fields.push_back(closed);
}

bool CurveHand::setField(const std::string& id, const FieldValue& value, const Scope& scope) {
  if (id != "x" && id != "y" && id != "closed") return false;
  if (!std::isfinite(value.number) || !frameIn(*scope.state) || isStroke_) return true;
  if (id == "closed") {
    if (controls_.size() < leastControls(true)) return true;
    isClosed_ = value.number != 0;
    if (!isClosed_ && phase_ == Phase::Resting) controls_ = elevated(controls_);
    return true;
  }
  if (!active_) return true;
  Vec2 at = shown(controls_[*active_], *scope.state);
  (id == "x" ? at.x : at.y) = value.number;
  controls_[*active_] = fromShown(at, *scope.state);
  return true;
}

}  // namespace kiri
