// SPDX-License-Identifier: MIT
#include "editor/tools/tear_tool.h"

#include <algorithm>
#include <cmath>

#include "editor/tools/drawn_line.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

Spot spotOn(const FoldedState& state, EdgeId edge, Vec2 paper) {
  return {state.pattern[edge].left, paper};
}

}  // namespace

std::optional<Vec2> TearTool::startUnder(const PointerEvent& event, const Scope& scope) const {
  const FoldedState& state = *scope.state;
  const auto pick =
      pickVertex(state, scope.map(event.pane), event.at, 3.0 / 2 * handleReach(event));
  if (!pick) return std::nullopt;
  const bool hasHinge =
      std::any_of(state.pattern.edges.begin(), state.pattern.edges.end(), [&](const Edge& edge) {
        return edge.kind == EdgeKind::Hinge &&
               (edge.from == pick->vertex || edge.to == pick->vertex);
      });
  if (!hasHinge) return std::nullopt;
  return state.pattern[pick->vertex];
}

/// True when the pointer is on the handle at the end of the tear.
bool TearTool::isOnEnd(const PointerEvent& event, const Scope& scope) const {
  if (phase_ != Phase::Resting || !path_.isThere() || event.pane != pane_) return false;
  const auto facet = facetAt(scope.state->pattern, path_.besides().back());
  if (!facet) return false;
  const Vec2 at = scope.map(pane_).toPixels(*scope.state, {*facet, path_.points().back()});
  return distance(at, event.at) < handleReach(event);
}

Reaction TearTool::press(const PointerEvent& event, const Scope& scope) {
  if (event.button != PointerButton::Left) return Reaction::ignored();
  if (phase_ == Phase::Clicking && event.pane == pane_) {
    pressedAt_ = event.at;
    return Reaction::handled();
  }
  if (isOnEnd(event, scope)) {
    path_.anchorEnd(*scope.state);
  } else {
    const auto start = startUnder(event, scope);
    if (!start) return Reaction::ignored();
    const bool isOneLayer = isOneLayer_;
    reset();
    isOneLayer_ = isOneLayer;
    hasAlt_ = event.modifiers.alt;
    path_.begin(*start);
  }
  pressedAt_ = event.at;
  pane_ = event.pane;
  phase_ = Phase::Dragging;
  return Reaction::handled();
}

void TearTool::follow(const PointerEvent& event, const Scope& scope) {
  if (!path_.follow(event, scope, phase_ == Phase::Dragging)) reset();
}

Reaction TearTool::release(const PointerEvent& event, const Scope& scope) {
  if (event.button != PointerButton::Left) return Reaction::ignored();
  const bool isClick = distance(event.at, pressedAt_) < kDragBegins;
  if (phase_ == Phase::Dragging) {
    if (!isClick) follow(event, scope);
    if (isClick && !path_.isThere()) {
      phase_ = Phase::Clicking;
    } else if (isBusy()) {
      phase_ = Phase::Resting;
    }
    return Reaction::handled();
  }
  if (phase_ != Phase::Clicking) return Reaction::ignored();
  follow(event, scope);
  if (!isBusy()) return Reaction::handled();
  if (!path_.anchorEnd(*scope.state) && path_.isThere()) phase_ = Phase::Resting;
  return Reaction::handled();
}

Reaction TearTool::pointer(const PointerEvent& event, const Scope& scope) {
  switch (event.action) {
    case PointerAction::Press:
      return press(event, scope);
    case PointerAction::Release:
      return event.pane == pane_ && isBusy() ? release(event, scope) : Reaction::ignored();
    case PointerAction::DoubleClick:
      if (phase_ != Phase::Clicking) return Reaction::ignored();
      phase_ = path_.isThere() ? Phase::Resting : Phase::Idle;
      return Reaction::handled();
    case PointerAction::Leave:
      hovered_.reset();
      return Reaction::ignored();
    case PointerAction::Move:
      break;
  }
  if (phase_ == Phase::Idle || phase_ == Phase::Resting) {
    hovered_ = startUnder(event, scope);
    return Reaction::ignored();
  }
  if (event.pane != pane_) return Reaction::ignored();
  if (phase_ == Phase::Dragging && distance(event.at, pressedAt_) < kDragBegins)
    return Reaction::handled();
  hasAlt_ = event.modifiers.alt;
  follow(event, scope);
  return Reaction::handled();
}

Reaction TearTool::key(const KeyEvent& event, const Scope&) {
  if (!event.isPress || !isBusy()) return Reaction::ignored();
  switch (event.key) {
    case Key::Escape:
    case Key::Delete:
      reset();
      return Reaction::handled();
    case Key::Backspace:
      if (phase_ != Phase::Clicking || !path_.dropAnchor()) return Reaction::ignored();
      return Reaction::handled();
    case Key::Enter:
      if (!path_.isThere() || phase_ == Phase::Dragging) return Reaction::ignored();
      phase_ = Phase::Resting;
      return {.isHandled = true, .wantsCommit = true};
    default:
      return Reaction::ignored();
  }
}

Reaction TearTool::wheel(const WheelEvent& event, const Scope&) {
  if (!event.modifiers.control || event.notches == 0 || !path_.isThere())
    return Reaction::ignored();
  isOneLayer_ = event.notches < 0;
  hasAlt_ = false;
  return Reaction::handled();
}

std::optional<Proposal> TearTool::proposal(const Scope&) const {
  if (!path_.isThere()) return std::nullopt;
  TearStep tear;
  tear.path = {Frame::Paper, path_.points()};
  tear.layers = AllLayers{};
  if (isOneLayer_ || hasAlt_) {
    ChosenLayers chosen;
    for (const Vec2 place : path_.besides()) chosen.facets.push_back({Frame::Paper, place});
    tear.layers = chosen;
  }
  Step step;
  step.action = std::move(tear);
  return Proposal{std::move(step), phase_ == Phase::Resting};
}

void TearTool::markHinges(const FoldedState& state, Vec2 place, Marks& marks) const {
  const auto vertex = vertexAt(state.pattern, place);
  if (!vertex) return;
  const HingeGraph graph(state);
  for (const EdgeId e : graph.at(*vertex)) {
    const Edge& edge = state.pattern[e];
    marks.push_back(PathMark{
        MarkRole::Possible,
        {spotOn(state, e, state.pattern[edge.from]), spotOn(state, e, state.pattern[edge.to])},
        false,
        false});
  }
}

Marks TearTool::marks(const Scope& scope) const {
  const FoldedState& state = *scope.state;
  const std::vector<Vec2>& points = path_.points();
  const std::vector<Vec2>& besides = path_.besides();
  Marks marks;
  const auto spotAt = [&](Vec2 place, std::size_t edge) {
    const auto facet = facetAt(state.pattern, edge < besides.size() ? besides[edge] : place);
    return facet ? std::optional<Spot>(Spot{*facet, place}) : std::nullopt;
  };
  if (hovered_ && phase_ != Phase::Dragging && phase_ != Phase::Clicking) {
    markHinges(state, *hovered_, marks);
    if (const auto spot = spotAt(*hovered_, besides.size()))
      marks.push_back(PointMark{MarkRole::Hovered, *spot});
  }
  if (!isBusy()) return marks;
  if (phase_ != Phase::Resting) {
    markHinges(state, points.back(), marks);
    marks.insert(marks.end(), path_.caught().begin(), path_.caught().end());
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto a = spotAt(points[i], i);
    const auto b = spotAt(points[i + 1], i);
    if (a && b) marks.push_back(PathMark{MarkRole::Line, {*a, *b}, false, false});
  }
  const std::size_t last = besides.empty() ? 0 : besides.size() - 1;
  if (const auto spot = spotAt(points.front(), 0))
    marks.push_back(PointMark{MarkRole::Handle, *spot});
  if (const auto spot = spotAt(points.back(), last); spot && path_.isThere())
    marks.push_back(PointMark{MarkRole::ActiveHandle, *spot});
  return marks;
}

std::vector<Field> TearTool::fields(const Scope&) const {
  std::vector<Field> fields;
  if (!path_.isThere()) return fields;
  Field size;
  size.id = "length";
  size.label = {KIRI_TEXT("editor/tools", "Length"), {}};
  size.value = path_.length();
  size.most = path_.mostLength();
  size.unit = "mm";
  size.help = {KIRI_TEXT("editor/tools", "Length of the tear along its edges"), {}};
  fields.push_back(size);
  Field layers;
  layers.id = "layers";
  layers.label = {KIRI_TEXT("editor/tools", "Layers"), {}};
  layers.kind = Field::Kind::Choice;
  layers.value = isOneLayer_ || hasAlt_ ? 1 : 0;
  layers.options = {{KIRI_TEXT("editor/tools", "All that have an edge here"), {}},
                    {KIRI_TEXT("editor/tools", "Only this layer"), {}}};
  layers.help = {KIRI_TEXT("editor/tools", "Alt while tearing takes only this layer"), {}};
  fields.push_back(layers);
  return fields;
}

Reaction TearTool::setField(const std::string& id, const FieldValue& value, const Scope& scope) {
  if (id == "layers") {
    isOneLayer_ = value.number != 0;
    hasAlt_ = false;
    return Reaction::handled();
  }
  if (id != "length") return Reaction::ignored();
  path_.setLength(value.number, scope.state->tolerance().pick());
  phase_ = phase_ == Phase::Clicking ? Phase::Resting : phase_;
  return Reaction::handled();
}

Phrase TearTool::hint(const Scope&) const {
  switch (phase_) {
    case Phase::Idle:
      break;
    case Phase::Dragging:
      return {KIRI_TEXT("editor/tools",
                        "Drag along the edges and release where the tear ends; Alt tears only this "
                        "layer"),
              {}};
    case Phase::Clicking:
      return {KIRI_TEXT("editor/tools",
                        "Click along the edges; a click inside an edge or a double click ends the "
                        "tear"),
              {}};
    case Phase::Resting:
      return {KIRI_TEXT("editor/tools", "Enter tears the paper; Esc leaves it whole"), {}};
  }
  if (hovered_)
    return {KIRI_TEXT("editor/tools", "Press and drag along one of the marked edges"), {}};
  return {KIRI_TEXT("editor/tools",
                    "Press where an edge begins, such as at the border, and drag along it"),
          {}};
}

CursorShape TearTool::cursor(const Scope&) const { return CursorShape::Tear; }

}  // namespace kiri
