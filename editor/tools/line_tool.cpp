// SPDX-License-Identifier: MIT
#include "editor/tools/line_tool.h"

#include <algorithm>
#include <cmath>

#include "editor/tools/tool_fields.h"

namespace kiri {
/// The construction stays chosen: it is how lines are placed, not what was begun.
void LineTool::reset() {
  const Construction kind = kind_;
  *this = LineTool();
  kind_ = kind;
  builder_.begin(kind);
}

bool LineTool::isBusy() const { return line_.isBusy() || pressed_ || !builder_.isEmpty(); }

/// Mirrors and projections begin with a line that is drawn, the others only pick.
bool LineTool::isDrawn() const {
  return kind_ == Construction::ByHand || kind_ == Construction::Project;
}

Reaction LineTool::pointer(const PointerEvent& event, const Scope& scope) {
  if (event.action == PointerAction::DoubleClick) {
    pressed_.reset();
    if (!offer_.isThere() || line_.isMoving()) return Reaction::ignored();
    return {.isHandled = true, .wantsCommit = true};
  }
  if (event.action == PointerAction::Press) {
    return event.button == PointerButton::Left ? press(event, scope) : Reaction::ignored();
  }
  if (event.action == PointerAction::Move) {
    if (!isDrawn()) builder_.hover(event, scope);
    offer_.hoverLayers(event, scope);
  }
  return byHand(event, scope);
}

Reaction LineTool::press(const PointerEvent& event, const Scope& scope) {
  if (offer_.isThere() && !line_.isMoving()) {
    if (!event.modifiers.control && line_.takeHandle(event, scope)) return Reaction::handled();
    if (offer_.pressLayers(event, scope)) return Reaction::handled();
    pressed_ = event;
    return Reaction::handled();
  }
  pane_ = event.pane;
  if (isDrawn()) {
    isDrawing_ = true;
    line_.pointer(event, scope);
    return Reaction::handled();
  }
  if (builder_.pick(event, scope)) showBuilt(scope);
  return Reaction::handled();
}

Reaction LineTool::byHand(const PointerEvent& event, const Scope& scope) {
  if (pressed_ && event.action == PointerAction::Release) {
    pressed_.reset();
    return Reaction::handled();
  }
  if (pressed_ && event.action == PointerAction::Move) {
    if (distance(event.at, pressed_->at) < kDragBegins) return Reaction::handled();
    const PointerEvent press = *pressed_;
    reset();
    pane_ = press.pane;
    if (!isDrawn()) return Reaction::handled();
    isDrawing_ = true;
    line_.begin(press, scope);
  }
  if (!line_.follow(event, scope)) return Reaction::ignored();
  isEndless_ = false;
  look(scope, isDrawing_);
  if (!line_.isMoving()) finish(scope);
  return Reaction::handled();
}

/// The line is let go of.
void LineTool::finish(const Scope& scope) {
  const bool wasDrawn = isDrawing_;
  isDrawing_ = false;
  const auto line = line_.on(*scope.state);
  if (wasDrawn && line && kind_ == Construction::Project) {
    builder_.give(*scope.state, *line);
    showBuilt(scope);
  }
  offer_.lookAgain(scope);
}

void LineTool::look(const Scope& scope, bool isNew) {
  const auto line = line_.on(*scope.state);
  if (!line) return offer_.drop();
  offer_.look(scope, {*line, pane_, std::nullopt, isEndless_, isNew});
}

/// Lines that pass the paper by are no solutions.
void LineTool::showBuilt(const Scope& scope) {
  solutions_ = 0;
  const auto built = builder_.build(scope);
  std::vector<Line2> lines;
  if (built) {
    isEndless_ = built->isEndless;
    for (const Line2& line : built->lines) {
      offer_.look(scope, placed(built->frame, line));
      if (offer_.isThere()) lines.push_back(line);
    }
  }
  if (lines.empty()) {
    line_.reset();
    return offer_.drop();
  }
  solutions_ = lines.size();
  solution_ = std::min(solution_, solutions_ - 1);
  const Line2& line = lines[solution_];
  line_.set(*scope.state, {built->frame, line.from, line.to}, pane_);
  offer_.look(scope, placed(built->frame, line));
  const auto segment = offer_.segment(*scope.state);
  if (isEndless_ && segment) line_.set(*scope.state, *segment, pane_);
}

FoldPlace LineTool::placed(FacetId frame, const Line2& line) const {
  return {{frame, line.from, line.to}, pane_, std::nullopt, isEndless_, true};
}

void LineTool::nextSolution(int by, const Scope& scope) {
  const auto count = static_cast<int>(solutions_);
  solution_ = static_cast<std::size_t>((static_cast<int>(solution_) + by + count) % count);
  showBuilt(scope);
}

void LineTool::startConstruction(Construction kind, const Scope& scope) {
  const auto drawn = line_.on(*scope.state);
  const bool uses = kind == Construction::Mirror || kind == Construction::Project;
  kind_ = kind;
  const Pane pane = pane_;
  reset();
  pane_ = pane;
  if (!uses || !drawn) return;
  builder_.give(*scope.state, *drawn);
  showBuilt(scope);
}

Reaction LineTool::key(const KeyEvent& event, const Scope& scope) {
  if (!event.isPress || !isBusy()) return Reaction::ignored();
  switch (event.key) {
    case Key::Escape:
      reset();
      return Reaction::handled();
    case Key::Enter:
      if (!offer_.isThere() || line_.isMoving()) return Reaction::ignored();
      return {.isHandled = true, .wantsCommit = true};
    case Key::Backspace:
      if (builder_.isEmpty() || offer_.isThere()) return Reaction::ignored();
      builder_.dropLast();
      return Reaction::handled();
    case Key::Space:
    case Key::Right:
    case Key::Down:
    case Key::Left:
    case Key::Up:
      if (solutions_ < 2) return Reaction::ignored();
      nextSolution(event.key == Key::Left || event.key == Key::Up ? -1 : 1, scope);
      return Reaction::handled();
    default:
      return offer_.key(event, scope) ? Reaction::handled() : Reaction::ignored();
  }
}

Reaction LineTool::wheel(const WheelEvent& event, const Scope& scope) {
  return offer_.wheel(event, scope) ? Reaction::handled() : Reaction::ignored();
}

std::optional<Proposal> LineTool::proposal(const Scope&) const {
  const auto step = offer_.step();
  if (!step) return std::nullopt;
  return Proposal{{*step, {}, {}, {}}, !line_.isMoving()};
}

Marks LineTool::marks(const Scope& scope) const {
  Marks marks;
  line_.addMarks(scope, MarkRole::Line, marks);
  offer_.addMarks(scope, marks);
  if (!isDrawn()) builder_.addMarks(scope, marks);
  return marks;
}

std::vector<TintedFacet> LineTool::tints(const Scope& scope) const { return offer_.tints(scope); }

std::vector<Field> LineTool::fields(const Scope& scope) const {
  std::vector<Field> fields = {choiceField(
      "construct", {KIRI_TEXT("editor/tools", "Place"), {}}, constructionNames(),
      static_cast<int>(kind_),
      {KIRI_TEXT("editor/tools", "How the line is placed: drawn, or by what it must do"), {}})};
  if (solutions_ > 1) {
    fields.push_back(
        numberField("solution", {KIRI_TEXT("editor/tools", "Solution"), {}},
                    static_cast<double>(solution_ + 1), {1, static_cast<double>(solutions_), 1, ""},
                    {KIRI_TEXT("editor/tools", "Several lines do this (Space: the next)"), {}}));
  }
  offer_.addFields(scope, fields);
  if (offer_.isThere() && !isEndless_) line_.addFields(fields);
  return fields;
}

Reaction LineTool::setField(const std::string& id, const FieldValue& value, const Scope& scope) {
  if (id == "construct") {
    if (!std::isfinite(value.number)) return Reaction::ignored();
    const int most = static_cast<int>(Construction::Project);
    const int kind = static_cast<int>(std::clamp(value.number, 0.0, static_cast<double>(most)));
    startConstruction(static_cast<Construction>(kind), scope);
    return Reaction::handled();
  }
  if (!offer_.isThere()) return Reaction::ignored();
  if (id == "solution" && solutions_ > 1 && std::isfinite(value.number)) {
    const double most = static_cast<double>(solutions_);
    solution_ = static_cast<std::size_t>(std::clamp(value.number, 1.0, most)) - 1;
    showBuilt(scope);
    return Reaction::handled();
  }
  if (offer_.setField(id, value, scope)) return Reaction::handled();
  if (isEndless_ || !line_.setField(id, value)) return Reaction::ignored();
  look(scope, false);
  return Reaction::handled();
}

Phrase LineTool::hint(const Scope& scope) const {
  if (offer_.isThere() && !line_.isMoving()) {
    if (const std::optional<Phrase> trouble = offer_.trouble(scope)) return *trouble;
    if (solutions_ > 1) {
      return {KIRI_TEXT("editor/tools", "Line %1 of %2: Space shows the next, Enter folds"),
              {std::to_string(solution_ + 1), std::to_string(solutions_)}};
    }
    return {KIRI_TEXT("editor/tools",
                      "Enter folds, Esc drops it; V valley, M mountain, Tab the other side, drag "
                      "the handles"),
            {}};
  }
  if (kind_ != Construction::ByHand) return builder_.hint();
  if (line_.isMoving())
    return {KIRI_TEXT("editor/tools", "Draw the line right across the paper, then release"), {}};
  return {KIRI_TEXT("editor/tools", "Draw the fold line: drag, or click both ends"), {}};
}

CursorShape LineTool::cursor(const Scope&) const { return CursorShape::Cross; }

}  // namespace kiri
