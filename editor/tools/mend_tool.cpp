// SPDX-License-Identifier: MIT
#include "editor/tools/mend_tool.h"

#include "editor/tools/drawn_line.h"

namespace kiri {
namespace {

bool hasTears(const FoldedState& state) {
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Tear) return true;
  }
  return false;
}

bool hasMendable(const FoldedState& state) {
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (canBeMended(state, EdgeId(e))) return true;
  }
  return false;
}

Vec2 middleOf(const FoldedState& state, EdgeId edge) {
  return lerp(state.pattern[state.pattern[edge].from], state.pattern[state.pattern[edge].to], 0.5);
}

}  // namespace

void MendTool::reset() {
  hovered_.reset();
  isPressed_ = false;
  isAll_ = false;
  hasAlt_ = false;
}

std::optional<EdgeId> MendTool::hoveredIn(const FoldedState& state) const {
  if (!hovered_) return std::nullopt;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (state.pattern.edges[e].kind == EdgeKind::Tear && middleOf(state, EdgeId(e)) == *hovered_)
      return EdgeId(e);
  }
  return std::nullopt;
}

TornRun MendTool::meant(const FoldedState& state, EdgeId edge) const {
  if (!isEdgeOnly_ && !hasAlt_ && canBeMended(state, edge)) return tornRunThrough(state, edge);
  const Edge& only = state.pattern[edge];
  return {{state.pattern[only.from], state.pattern[only.to]}, {edge}};
}

Reaction MendTool::pointer(const PointerEvent& event, const Scope& scope) {
  const bool isPress = event.action == PointerAction::Press && event.button == PointerButton::Left;
  if (isBusy() && !isPress) return Reaction::ignored();
  if (event.action == PointerAction::Leave) hovered_.reset();
  if (event.action != PointerAction::Move && !isPress) return Reaction::ignored();
  const FoldedState& state = *scope.state;
  hasAlt_ = event.modifiers.alt;
  hovered_.reset();
  const auto isTorn = [&](EdgeId e) { return state.pattern[e].kind == EdgeKind::Tear; };
  const std::vector<EdgeHit> hits =
      edgesUnder(state, scope.map(event.pane), event.at, handleReach(event), isTorn);
  for (const EdgeHit& hit : hits) {
    if (!hovered_ || (canBeMended(state, hit.edge) && !canBeMended(state, *hoveredIn(state))))
      hovered_ = middleOf(state, hit.edge);
  }
  if (!isPress) return Reaction::ignored();
  isAll_ = false;
  isPressed_ = hovered_.has_value();
  if (!isPressed_) return Reaction::ignored();
  return {.isHandled = true, .wantsCommit = true};
}

Reaction MendTool::key(const KeyEvent& event, const Scope&) {
  if (!event.isPress) return Reaction::ignored();
  if (event.key == Key::Escape && isBusy()) {
    reset();
    return Reaction::handled();
  }
  if (event.key != Key::Enter || (!isAll_ && !hovered_)) return Reaction::ignored();
  return {.isHandled = true, .wantsCommit = true};
}

Reaction MendTool::wheel(const WheelEvent& event, const Scope&) {
  if (!event.modifiers.control || event.notches == 0 || !hovered_) return Reaction::ignored();
  isOneLayer_ = event.notches < 0;
  return Reaction::handled();
}

std::optional<Proposal> MendTool::proposal(const Scope& scope) const {
  MendStep mend;
  if (!isAll_) {
    const auto edge = hoveredIn(*scope.state);
    if (!edge) return std::nullopt;
    const TornRun run = meant(*scope.state, *edge);
    mend.path = {Frame::Paper, run.points};
    mend.layers = AllLayers{};
    if (isOneLayer_) {
      ChosenLayers chosen;
      for (const EdgeId e : run.edges) {
        chosen.facets.push_back(
            {Frame::Paper, interiorPointOf(scope.state->pattern, scope.state->pattern[e].left)});
      }
      mend.layers = chosen;
    }
  }
  Step step;
  step.action = std::move(mend);
  return Proposal{std::move(step), true};
}

Marks MendTool::marks(const Scope& scope) const {
  const FoldedState& state = *scope.state;
  Marks marks;
  const auto add = [&](EdgeId e, MarkRole role) {
    const Edge& edge = state.pattern[e];
    for (const FacetId side : {edge.left, edge.right}) {
      marks.push_back(
          PathMark{role,
                   {Spot{side, state.pattern[edge.from]}, Spot{side, state.pattern[edge.to]}},
                   false,
                   false});
      if (role != MarkRole::Fault) break;  // the sides lie together
    }
  };
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (canBeMended(state, EdgeId(e))) add(EdgeId(e), MarkRole::Possible);
  }
  const auto hovered = hoveredIn(state);
  if (!hovered) return marks;
  for (const EdgeId e : meant(state, *hovered).edges)
    add(e, canBeMended(state, e) ? MarkRole::Hovered : MarkRole::Fault);
  return marks;
}

std::vector<Field> MendTool::fields(const Scope& scope) const {
  std::vector<Field> fields;
  if (!hasTears(*scope.state)) return fields;
  Field reach;
  reach.id = "reach";
  reach.label = {KIRI_TEXT("editor/tools", "Mend"), {}};
  reach.kind = Field::Kind::Choice;
  reach.value = isEdgeOnly_ ? 1 : 0;
  reach.options = {{KIRI_TEXT("editor/tools", "The whole tear"), {}},
                   {KIRI_TEXT("editor/tools", "One edge"), {}}};
  reach.help = {KIRI_TEXT("editor/tools", "How much a click mends; Alt: one edge"), {}};
  fields.push_back(reach);
  Field layers;
  layers.id = "layers";
  layers.label = {KIRI_TEXT("editor/tools", "Layers"), {}};
  layers.kind = Field::Kind::Choice;
  layers.value = isOneLayer_ ? 1 : 0;
  layers.options = {{KIRI_TEXT("editor/tools", "All that are torn here"), {}},
                    {KIRI_TEXT("editor/tools", "Only this layer"), {}}};
  layers.help = {KIRI_TEXT("editor/tools", "Which of the torn edges that lie on each other"), {}};
  fields.push_back(layers);
  Field all;
  all.id = "all";
  all.label = {KIRI_TEXT("editor/tools", "Mend everything"), {}};
  all.kind = Field::Kind::Button;
  all.isEnabled = hasMendable(*scope.state);
  all.help = {KIRI_TEXT("editor/tools", "Mends every torn edge whose sides lie together"), {}};
  fields.push_back(all);
  return fields;
}

Reaction MendTool::setField(const std::string& id, const FieldValue& value, const Scope& scope) {
  if (id == "reach") {
    isEdgeOnly_ = value.number != 0;
    return Reaction::handled();
  }
  if (id == "layers") {
    isOneLayer_ = value.number != 0;
    return Reaction::handled();
  }
  if (id != "all") return Reaction::ignored();
  if (!hasMendable(*scope.state)) return Reaction::handled();
  isAll_ = true;
  return {.isHandled = true, .wantsCommit = true};
}

Phrase MendTool::hint(const Scope& scope) const {
  const FoldedState& state = *scope.state;
  if (!hasTears(state)) return {KIRI_TEXT("editor/tools", "Nothing is torn"), {}};
  const auto hovered = hoveredIn(state);
  if (hovered && !canBeMended(state, *hovered)) {
    return {KIRI_TEXT("editor/tools",
                      "The sides of this tear have moved apart; fold them back together first"),
            {}};
  }
  if (hovered) return {KIRI_TEXT("editor/tools", "Click to mend this tear"), {}};
  return {KIRI_TEXT("editor/tools", "Click a torn edge to mend it"), {}};
}

CursorShape MendTool::cursor(const Scope& scope) const {
  const auto hovered = hoveredIn(*scope.state);
  if (!hovered) return CursorShape::Arrow;
  return canBeMended(*scope.state, *hovered) ? CursorShape::Hand : CursorShape::Forbidden;
}

}  // namespace kiri
