// SPDX-License-Identifier: MIT
#include "editor/tools/cut_hand.h"

#include "editor/tools/drawn_line.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

/// The step with the line as it is seen from the front, for cuts straight down through everything.
void drawFromFront(const FoldedState& state, FacetId frame, Step& step) {
  const Rigid& pose = state.poseOf(frame);
  if (auto* straight = std::get_if<StraightCutStep>(&step.action)) {
    straight->line = {Frame::Model, flatten(pose.apply(straight->line.from)),
                      flatten(pose.apply(straight->line.to)), std::nullopt};
  } else if (auto* curve = std::get_if<CurveCutStep>(&step.action)) {
    for (Vec2& control : curve->controls) control = flatten(pose.apply(control));
    curve->frame = Frame::Model;
    curve->facet.reset();
  }
}

}  // namespace

Step CutHand::step(const Scope& scope, const Line& line, bool isResting) const {
  const FoldedState& state = *scope.state;
  Step step = line.step;
  const LayerChoice layers = layers_.choice(scope, line.trace);
  if (std::holds_alternative<ThroughAll>(layers)) drawFromFront(state, line.trace.frame, step);
  if (auto* straight = std::get_if<StraightCutStep>(&step.action)) straight->layers = layers;
  if (auto* curve = std::get_if<CurveCutStep>(&step.action)) curve->layers = layers;
  keepOf(step) = isResting ? keep_.keep(state) : Keep{};
  return step;
}

void CutHand::lineRests(const Scope& scope, const Line& line, CutHabit habit) {
  const Step all = step(scope, line, false);
  keep_.suggest(scope, all, habit);
  keep_.showDropped(scope, all);
}

bool CutHand::press(const PointerEvent& event, const Scope& scope) {
  click_.reset();
  pressedAt_ = event.at;
  if (keep_.takeMark(event, scope)) return true;
  const auto pick = pickPaper(*scope.state, scope.map(event.pane), event.at);
  if (!pick) return false;
  click_ = pick->spot.paper;
  return true;
}

bool CutHand::follow(const PointerEvent& event, const Scope& scope, const Line& line) {
  const bool isRelease =
      event.action == PointerAction::Release && event.button == PointerButton::Left;
  if (keep_.isMoving()) {
    if (isRelease || event.action == PointerAction::Move) keep_.follow(event, scope);
    if (isRelease) keep_.showDropped(scope, step(scope, line, false));
    return true;
  }
  if (!click_) return false;
  if (isRelease) {
    const Vec2 place = *click_;
    click_.reset();
    if (distance(event.at, pressedAt_) >= handleReach(event)) return true;
    const Step all = step(scope, line, false);
    keep_.toggle(scope, all, place);
    keep_.showDropped(scope, all);
  }
  return true;
}

Reaction CutHand::wheel(const WheelEvent& event, const Scope& scope, const Line& line) {
  if (!event.modifiers.control || event.notches == 0) return Reaction::ignored();
  layers_.walk(event.notches > 0 ? 1 : -1, scope, line.trace);
  return Reaction::handled();
}

void CutHand::addFields(const Scope& scope, const Line& line, std::vector<Field>& fields) const {
  layers_.addFields(scope, line.trace, fields);
  keep_.addFields(fields);
}

bool CutHand::setField(const std::string& id, const FieldValue& value, const Scope& scope,
                       const Line& line) {
  return layers_.setField(id, value, *scope.state, line.trace) || keep_.setField(id, value);
}

}  // namespace kiri
