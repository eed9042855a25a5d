// SPDX-License-Identifier: MIT
#include "editor/tools/add_edge_tool.h"

#include "core/paper/inscribe.h"

namespace kiri {
namespace {

/// The point nearest to `point` on an edge of the plane of `frame` that is not passed over by
/// `except`; in the paper frame of `frame`.
Vec2 onNearestEdge(const FoldedState& state, FacetId frame, Vec2 point) {
  const Rigid& pose = state.poseOf(frame);
  Vec2 best = point;
  double nearest = HUGE_VAL;
  for (const FacetId f : state.layers.sets()[state.layers.setOf(frame)].upward) {
    const bool isOwn = f == frame;
    const Vec2 here = isOwn ? point : state.poseOf(f).pullBack(pose.apply(point));
    for (const EdgeUse use : state.pattern[f].border) {
      const Arc arc = arcOf(state.pattern, use);
      const Nearest found = nearestOn(arc, here);
      if (found.distance >= nearest) continue;
      nearest = found.distance;
      const Vec2 place = pointAt(arc, found.t);
      best = isOwn ? place : pose.pullBack(state.poseOf(f).apply(place));
    }
  }
  return best;
}

}  // namespace

std::optional<PlaneTrace> AddEdgeTool::trace(const Scope& scope) const {
  const auto here = hand_.on(*scope.state);
  if (!here) return std::nullopt;
  return PlaneTrace{hand_.pane(), here->facet, {here->from, here->to}};
}

Reaction AddEdgeTool::pointer(const PointerEvent& event, const Scope& scope) {
  if (!hand_.pointer(event, scope)) return Reaction::ignored();
  return Reaction::handled();
}

Reaction AddEdgeTool::key(const KeyEvent& event, const Scope&) {
  if (!event.isPress || !isBusy()) return Reaction::ignored();
  if (event.key == Key::Escape || event.key == Key::Delete) {
    reset();
    return Reaction::handled();
  }
  if (event.key != Key::Enter || !isResting()) return Reaction::ignored();
  return {.isHandled = true, .wantsCommit = true};
}

Reaction AddEdgeTool::wheel(const WheelEvent& event, const Scope& scope) {
  const auto here = trace(scope);
  if (!here || !event.modifiers.control || event.notches == 0) return Reaction::ignored();
  layers_.walk(event.notches > 0 ? 1 : -1, scope, *here);
  return Reaction::handled();
}

void AddEdgeTool::reset() {
  hand_.reset();
  layers_.reset();
}

std::optional<Proposal> AddEdgeTool::proposal(const Scope& scope) const {
  const auto drawn = hand_.drawn();
  const auto here = trace(scope);
  if (!drawn || !here) return std::nullopt;
  AddEdgeStep edge;
  edge.line = *drawn;
  edge.layers = layers_.choice(scope, *here);
  Step step;
  step.action = std::move(edge);
  return Proposal{std::move(step), isResting()};
}

std::vector<FacetLine> AddEdgeTool::beyondDrawn(const Scope& scope) const {
  std::vector<FacetLine> beyond;
  const FoldedState& state = *scope.state;
  const auto line = hand_.on(state);
  const auto here = trace(scope);
  if (!line || !here || !isResting()) return beyond;
  for (const FacetId facet : layers_.taken(scope, *here)) {
    const FacetLine drawn = lineOn(state, *line, facet);
    const double near = state.tolerance().pick() / distance(drawn.from, drawn.to);
    const auto at = [&](double t) { return lerp(drawn.from, drawn.to, t); };
    for (const Chord& chord : chordsOf(state.pattern, facet, drawn.from, drawn.to)) {
      if (chord.t0 < -near) beyond.push_back({facet, at(chord.t0), at(0)});
      if (chord.t1 > 1 + near) beyond.push_back({facet, at(1), at(chord.t1)});
    }
  }
  return beyond;
}

Marks AddEdgeTool::marks(const Scope& scope) const {
  Marks marks;
  for (const FacetLine& part : beyondDrawn(scope)) {
    const std::vector<MarkPlace> places{Spot{part.facet, part.from}, Spot{part.facet, part.to}};
    marks.push_back(PathMark{MarkRole::Possible, places, false, false});
  }
  hand_.addMarks(scope, MarkRole::Line, marks);
  return marks;
}

std::vector<Field> AddEdgeTool::fields(const Scope& scope) const {
  std::vector<Field> fields;
  hand_.addFields(fields);
  const auto here = trace(scope);
  if (!here || !isResting()) return fields;
  layers_.addFields(scope, *here, fields);
  Field project;
  project.id = "project";
  project.label = {KIRI_TEXT("editor/tools", "Onto the nearest edges"), {}};
  project.kind = Field::Kind::Button;
  project.help = {KIRI_TEXT("editor/tools", "Puts both ends onto the edges nearest to them"), {}};
  fields.push_back(project);
  return fields;
}

void AddEdgeTool::project(const Scope& scope) {
  const auto here = hand_.on(*scope.state);
  if (!here || !isResting()) return;
  const FacetLine line{here->facet, onNearestEdge(*scope.state, here->facet, here->from),
                       onNearestEdge(*scope.state, here->facet, here->to)};
  if (distance(line.from, line.to) > scope.state->tolerance().pick())
    hand_.set(*scope.state, line, hand_.pane());
}

Reaction AddEdgeTool::setField(const std::string& id, const FieldValue& value, const Scope& scope) {
  if (!isBusy()) return Reaction::ignored();
  if (id == "project") {
    project(scope);
    return Reaction::handled();
  }
  const auto here = trace(scope);
  const bool isKnown =
      hand_.setField(id, value) || (here && layers_.setField(id, value, *scope.state, *here));
  return isKnown ? Reaction::handled() : Reaction::ignored();
}

Phrase AddEdgeTool::hint(const Scope& scope) const {
  if (!isBusy()) {
    return {KIRI_TEXT("editor/tools", "Draw an edge across the paper: drag, or click both ends"),
            {}};
  }
  if (!isResting())
    return {KIRI_TEXT("editor/tools", "Release or click where the edge ends; Esc drops it"), {}};
  if (beyondDrawn(scope).empty()) return {KIRI_TEXT("editor/tools", "Enter adds the edge"), {}};
  return {KIRI_TEXT("editor/tools",
                    "Enter adds the edge and the marked part: it goes from edge to edge"),
          {}};
}

CursorShape AddEdgeTool::cursor(const Scope&) const { return CursorShape::Pen; }

}  // namespace kiri
