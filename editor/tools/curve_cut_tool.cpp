// SPDX-License-Identifier: MIT
#include "editor/tools/curve_cut_tool.h"

namespace kiri {

std::optional<CutHand::Line> CurveCutTool::line(const Scope& scope) const {
  auto cut = curve_.cut(*scope.state);
  auto trace = curve_.trace(*scope.state);
  if (!cut || !trace) return std::nullopt;
  Step step;
  step.action = std::move(*cut);
  return CutHand::Line{std::move(step), std::move(*trace)};
}

void CurveCutTool::looksAtParts(const Scope& scope) {
  if (!curve_.isResting() || curve_.isMoving()) return;
  if (const auto here = line(scope))
    cut_.lineRests(scope, *here, curve_.isClosed() ? CutHabit::Trim : CutHabit::Shape);
}

Reaction CurveCutTool::pointer(const PointerEvent& event, const Scope& scope) {
  if (event.action == PointerAction::Press) {
    if (event.button != PointerButton::Left) return Reaction::ignored();
    if (!curve_.isBusy()) cut_.reset();
    const bool wasResting = curve_.isResting();
    if (curve_.press(event, scope)) {
      looksAtParts(scope);
      return Reaction::handled();
    }
    return wasResting && cut_.press(event, scope) ? Reaction::handled() : Reaction::ignored();
  }
  if (curve_.isResting() && !curve_.isMoving()) {
    const auto here = line(scope);
    if (here && cut_.follow(event, scope, *here)) return Reaction::handled();
  }
  if (!curve_.follow(event, scope)) return Reaction::ignored();
  if (event.action != PointerAction::Move) looksAtParts(scope);
  return Reaction::handled();
}

Reaction CurveCutTool::key(const KeyEvent& event, const Scope& scope) {
  if (!event.isPress || !isBusy()) return Reaction::ignored();
  if (event.key == Key::Escape) {
    reset();
    return Reaction::handled();
  }
  if (cut_.isMoving()) return Reaction::ignored();
  if (curve_.key(event, scope)) {
    looksAtParts(scope);
    return Reaction::handled();
  }
  if (event.key != Key::Enter || !curve_.isResting() || curve_.isMoving())
    return Reaction::ignored();
  return {.isHandled = true, .wantsCommit = true};
}

Reaction CurveCutTool::wheel(const WheelEvent& event, const Scope& scope) {
  const auto here = line(scope);
  if (!here) return Reaction::ignored();
  Reaction reaction = cut_.wheel(event, scope, *here);
  if (reaction.isHandled) looksAtParts(scope);
  return reaction;
}

void CurveCutTool::reset() {
  curve_.reset();
  cut_.reset();
}

std::optional<Proposal> CurveCutTool::proposal(const Scope& scope) const {
  const auto here = line(scope);
  if (!here) return std::nullopt;
  const bool isResting = curve_.isResting();
  return Proposal{cut_.step(scope, *here, isResting), isResting && !curve_.isMoving()};
}

Marks CurveCutTool::marks(const Scope& scope) const {
  Marks marks;
  curve_.addMarks(scope, marks);
  if (curve_.isResting()) cut_.addMarks(scope, marks);
  return marks;
}

std::vector<Field> CurveCutTool::fields(const Scope& scope) const {
  std::vector<Field> fields;
  curve_.addFields(scope, fields);
  const auto here = line(scope);
  if (here && curve_.isResting()) cut_.addFields(scope, *here, fields);
  return fields;
}

Reaction CurveCutTool::setField(const std::string& id, const FieldValue& value,
                                const Scope& scope) {
  if (!isBusy()) return Reaction::ignored();
  if (!curve_.setField(id, value, scope)) {
    const auto here = line(scope);
    if (!here || !cut_.setField(id, value, scope, *here)) return Reaction::ignored();
  }
  looksAtParts(scope);
  return Reaction::handled();
}

Phrase CurveCutTool::hint(const Scope& scope) const {
  if (!curve_.isBusy()) {
    return {
        KIRI_TEXT("editor/tools", "Click the control points of a curve, or draw it in one stroke"),
        {}};
  }
  if (!curve_.isResting()) {
    if (!line(scope))
      return {KIRI_TEXT("editor/tools", "Click the next point; Backspace takes the last one back"),
              {}};
    return {KIRI_TEXT("editor/tools",
                      "Go on clicking points; Enter or a double click ends the curve, a click on "
                      "its start closes it"),
            {}};
  }
  return {KIRI_TEXT("editor/tools",
                    "Enter cuts; drag points, double-click the curve for one more, click a piece "
                    "to keep or drop it"),
          {}};
}

CursorShape CurveCutTool::cursor(const Scope&) const {
  if (curve_.isMoving() && curve_.isResting()) return CursorShape::ClosedHand;
  if (cut_.isMoving()) return CursorShape::ClosedHand;
  if (curve_.isOverControl()) return CursorShape::Hand;
  return curve_.isResting() ? CursorShape::Scissors : CursorShape::Pen;
}

}  // namespace kiri
