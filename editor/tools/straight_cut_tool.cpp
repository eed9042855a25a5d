// SPDX-License-Identifier: MIT
#include "editor/tools/straight_cut_tool.h"

namespace kiri {

std::optional<CutHand::Line> StraightCutTool::line(const Scope& scope) const {
  const auto drawn = hand_.drawn();
  const auto here = hand_.on(*scope.state);
  if (!drawn || !here) return std::nullopt;
  StraightCutStep cut;
  cut.line = *drawn;
  Step step;
  step.action = std::move(cut);
  return CutHand::Line{std::move(step), {hand_.pane(), here->facet, {here->from, here->to}}};
}

void StraightCutTool::looksAtParts(const Scope& scope) {
  if (!isResting()) return;
  if (const auto here = line(scope)) cut_.lineRests(scope, *here, CutHabit::Trim);
}

Reaction StraightCutTool::press(const PointerEvent& event, const Scope& scope) {
  if (event.button != PointerButton::Left) return Reaction::ignored();
  press_.reset();
  if (isResting() && line(scope) && !hand_.takeHandle(event, scope)) {
    if (cut_.press(event, scope)) {
      if (cut_.hasClick()) press_ = event;
      return Reaction::handled();
    }
    cut_.reset();
    hand_.begin(event, scope);
    return Reaction::handled();
  }
  if (!hand_.isMoving()) cut_.reset();
  hand_.pointer(event, scope);
  return Reaction::handled();
}

Reaction StraightCutTool::pointer(const PointerEvent& event, const Scope& scope) {
  if (event.action == PointerAction::Press) return press(event, scope);
  if (press_ && event.action == PointerAction::Move &&
      distance(event.at, press_->at) >= kDragBegins) {
    // A drag on the paper is another cut.
    cut_.reset();
    hand_.begin(*press_, scope);
    press_.reset();
  }
  if (isResting()) {
    const auto here = line(scope);
    if (here && cut_.follow(event, scope, *here)) {
      if (event.action == PointerAction::Release) press_.reset();
      return Reaction::handled();
    }
  }
  if (!hand_.follow(event, scope)) return Reaction::ignored();
  if (event.action == PointerAction::Release) looksAtParts(scope);
  return Reaction::handled();
}

Reaction StraightCutTool::key(const KeyEvent& event, const Scope&) {
  if (!event.isPress || !isBusy()) return Reaction::ignored();
  if (event.key == Key::Escape || event.key == Key::Delete) {
    reset();
    return Reaction::handled();
  }
  if (event.key != Key::Enter || !isResting() || cut_.isMoving()) return Reaction::ignored();
  return {.isHandled = true, .wantsCommit = true};
}

Reaction StraightCutTool::wheel(const WheelEvent& event, const Scope& scope) {
  const auto here = line(scope);
  if (!here) return Reaction::ignored();
  Reaction reaction = cut_.wheel(event, scope, *here);
  if (reaction.isHandled) looksAtParts(scope);
  return reaction;
}

void StraightCutTool::reset() {
  hand_.reset();
  cut_.reset();
  press_.reset();
}

std::optional<Proposal> StraightCutTool::proposal(const Scope& scope) const {
  const auto here = line(scope);
  if (!here) return std::nullopt;
  return Proposal{cut_.step(scope, *here, isResting()), isResting()};
}

Marks StraightCutTool::marks(const Scope& scope) const {
  Marks marks;
  hand_.addMarks(scope, MarkRole::Line, marks);
  if (isResting()) cut_.addMarks(scope, marks);
  return marks;
}

std::vector<Field> StraightCutTool::fields(const Scope& scope) const {
  std::vector<Field> fields;
  hand_.addFields(fields);
  const auto here = line(scope);
  if (here && isResting()) cut_.addFields(scope, *here, fields);
  return fields;
}

Reaction StraightCutTool::setField(const std::string& id, const FieldValue& value,
                                   const Scope& scope) {
  if (!isBusy()) return Reaction::ignored();
  if (!hand_.setField(id, value)) {
    const auto here = line(scope);
    if (!here || !cut_.setField(id, value, scope, *here)) return Reaction::ignored();
  }
  looksAtParts(scope);
  return Reaction::handled();
}

Phrase StraightCutTool::hint(const Scope&) const {
  if (!isBusy()) {
    return {KIRI_TEXT("editor/tools", "Draw a cut across the paper: drag, or click both ends"), {}};
  }
  if (!isResting())
    return {KIRI_TEXT("editor/tools", "Release or click where the cut ends; Esc drops it"), {}};
  return {KIRI_TEXT("editor/tools",
                    "Enter cuts; drag the ends, click a piece to keep or drop it, or drag the mark "
                    "to the side that stays"),
          {}};
}

CursorShape StraightCutTool::cursor(const Scope&) const {
  const bool isHeld = (hand_.isMoving() && hand_.isThere()) || cut_.isMoving();
  return isHeld && isResting() ? CursorShape::ClosedHand : CursorShape::Scissors;
}

}  // namespace kiri
