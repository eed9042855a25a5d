// SPDX-License-Identifier: MIT
#include "editor/tools/tear_tool.h"

#include <algorithm>
#include <cmath>

#include "editor/tools/drawn_line.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

constexpr double kClick = 4;

/// A walk without its detours: what lies between two visits of a vertex is left out.
std::vector<VertexId> withoutLoops(const std::vector<VertexId>& walk) {
  std::vector<VertexId> way;
  for (const VertexId v : walk) {
    const auto seen = std::find(way.begin(), way.end(), v);
    if (seen != way.end()) way.erase(seen, way.end());
    way.push_back(v);
  }
  return way;
}

/// The facet beside an edge that is nearer to the eye, or any.
FacetId besideOf(const FoldedState& state, EdgeId edge) { return state.pattern[edge].left; }

Spot spotOn(const FoldedState& state, EdgeId edge, Vec2 paper) {
  return {besideOf(state, edge), paper};
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

Reaction TearTool::press(const PointerEvent& event, const Scope& scope) {
  if (event.button != PointerButton::Left) return Reaction::ignored();
  pressedAt_ = event.at;
  hasAlt_ = event.modifiers.alt;
  if (phase_ == Phase::Clicking && event.pane == pane_) return Reaction::handled();
  const auto start = startUnder(event, scope);
  if (!start) return Reaction::ignored();
  const bool goesOn = phase_ == Phase::Resting && hasPath() &&
                      distance(*start, path_.back()) <= scope.state->tolerance().pick();
  if (!goesOn) {
    const bool isOneLayer = isOneLayer_;
    reset();
    isOneLayer_ = isOneLayer;
    hasAlt_ = event.modifiers.alt;
    pressedAt_ = event.at;
    anchors_ = {*start};
    path_ = {*start};
  } else if (anchors_.back() != *start) {
    anchors_.push_back(*start);
  }
  pane_ = event.pane;
  phase_ = Phase::Dragging;
  return Reaction::handled();
}

void TearTool::follow(const PointerEvent& event, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(pane_);
  const auto start = vertexAt(state.pattern, anchors_.back());
  if (!start) return reset();
  const HingeGraph graph(state);
  const HingeGraph::Ways ways = graph.from(*start);
  const auto isReached = [&](EdgeId e) {
    const Edge& edge = state.pattern[e];
    return edge.kind == EdgeKind::Hinge && std::isfinite(ways.far[edge.from.index]);
  };
  // Of edges that lie on each other the one is meant that the tear comes to first.
  const EdgeHit* best = nullptr;
  double least = 0;
  const std::vector<EdgeHit> hits = edgesUnder(state, map, event.at, HUGE_VAL, isReached);
  for (const EdgeHit& hit : hits) {
    const Edge& edge = state.pattern[hit.edge];
    const double far = std::min(ways.far[edge.from.index], ways.far[edge.to.index]);
    if (best && far >= least) continue;
    best = &hit;
    least = far;
  }
  if (!best) return;
  EdgeHit hit = *best;
  const Edge& edge = state.pattern[hit.edge];
  // A handle's reach around each vertex means the vertex.
  VertexId nearest = hit.t < 0.5 ? edge.from : edge.to;
  const Vec2 end = map.toPixels(state, spotOn(state, hit.edge, state.pattern[nearest]));
  const Vec2 at = map.toPixels(state, spotOn(state, hit.edge, hit.paper));
  const bool isAtVertex = distance(end, at) <= handleReach(event);
  if (!isAtVertex && scope.snaps.isOn) {
    const Vec2 a = state.pattern[edge.from];
    const Vec2 b = state.pattern[edge.to];
    const auto caught = snapPoint(state, map, event.at, scope.snaps, besideOf(state, hit.edge));
    if (caught && caught->kind != SnapKind::None && caught->kind != SnapKind::Edge) {
      const Nearest there = nearestOn(Arc::line(a, b), caught->spot.paper);
      if (there.distance <= state.tolerance().pick()) {
        hit.t = there.t;
        hit.paper = caught->spot.paper;
      }
    }
  }
  walkTo(hit, isAtVertex, nearest, scope);
}

void TearTool::walkTo(const EdgeHit& hit, bool isAtVertex, VertexId vertex, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const HingeGraph graph(state);
  std::vector<VertexId> walk;
  HingeGraph::Ways ways;
  for (const Vec2 place : anchors_) {
    const auto anchor = vertexAt(state.pattern, place);
    if (!anchor) return reset();
    if (walk.empty()) {
      walk.push_back(*anchor);
    } else {
      const std::vector<VertexId> more = ways.to(*anchor);
      walk.insert(walk.end(), more.begin(), more.end());
    }
    ways = graph.from(*anchor);
  }
  VertexId target = vertex;
  if (!isAtVertex) {
    const Edge& edge = state.pattern[hit.edge];
    const double byFrom = ways.far[edge.from.index] + distance(state.pattern[edge.from], hit.paper);
    const double byTo = ways.far[edge.to.index] + distance(state.pattern[edge.to], hit.paper);
    target = byFrom <= byTo ? edge.from : edge.to;
  }
  const std::vector<VertexId> more = ways.to(target);
  walk.insert(walk.end(), more.begin(), more.end());
  take(state, graph, withoutLoops(walk), hit, isAtVertex);
}

void TearTool::take(const FoldedState& state, const HingeGraph& graph, std::vector<VertexId> way,
                    const EdgeHit& hit, bool isAtVertex) {
  const CreasePattern& pattern = state.pattern;
  const Edge& last = pattern[hit.edge];
  const auto isLast = [&](VertexId a, VertexId b) {
    return (a == last.from && b == last.to) || (a == last.to && b == last.from);
  };
  // Back on the edge that the walk came along: the path ends inside it.
  if (!isAtVertex && way.size() > 1 && isLast(way[way.size() - 2], way.back())) way.pop_back();
  path_.clear();
  besides_.clear();
  for (std::size_t i = 0; i < way.size(); ++i) {
    path_.push_back(pattern[way[i]]);
    if (i == 0) continue;
    for (const EdgeId e : graph.at(way[i - 1])) {
      if (graph.otherEnd(e, way[i - 1]) != way[i]) continue;
      besides_.push_back(interiorPointOf(pattern, besideOf(state, e)));
      break;
    }
  }
  farEnd_ = path_.back();
  if (!isAtVertex && distance(path_.back(), hit.paper) > state.tolerance().pick()) {
    farEnd_ = pattern[way.back() == last.from ? last.to : last.from];
    path_.push_back(hit.paper);
    besides_.push_back(interiorPointOf(pattern, besideOf(state, hit.edge)));
  }
  std::vector<Vec2> anchors;
  for (const Vec2 anchor : anchors_) {
    if (std::find(path_.begin(), path_.end(), anchor) != path_.end()) anchors.push_back(anchor);
  }
  anchors_ = std::move(anchors);
  if (phase_ == Phase::Dragging && isAtVertex && anchors_.back() != path_.back())
    anchors_.push_back(path_.back());
}

Reaction TearTool::release(const PointerEvent& event, const Scope& scope) {
  if (event.button != PointerButton::Left) return Reaction::ignored();
  const bool isClick = distance(event.at, pressedAt_) < kClick;
  if (phase_ == Phase::Dragging) {
    if (!isClick) follow(event, scope);
    if (isClick && path_.size() < 2) {
      phase_ = Phase::Clicking;
    } else if (isBusy()) {
      phase_ = Phase::Resting;
    }
    return Reaction::handled();
  }
  if (phase_ != Phase::Clicking) return Reaction::ignored();
  follow(event, scope);
  if (!isBusy()) return Reaction::handled();
  const bool isAtVertex = vertexAt(scope.state->pattern, path_.back()).has_value();
  if (!isAtVertex || (hasPath() && anchors_.back() == path_.back())) {
    phase_ = Phase::Resting;
  } else if (anchors_.back() != path_.back()) {
    anchors_.push_back(path_.back());
  }
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
      phase_ = hasPath() ? Phase::Resting : Phase::Idle;
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
  hasAlt_ = event.modifiers.alt;
  if (phase_ == Phase::Dragging && distance(event.at, pressedAt_) < kClick && !hasPath())
    return Reaction::handled();
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
    case Key::Backspace: {
      if (phase_ != Phase::Clicking || anchors_.size() < 2) return Reaction::ignored();
      anchors_.pop_back();
      path_.resize(1);
      besides_.clear();
      return Reaction::handled();
    }
    case Key::Enter:
      if (!hasPath() || phase_ == Phase::Dragging) return Reaction::ignored();
      phase_ = Phase::Resting;
      return {.isHandled = true, .wantsCommit = true};
    default:
      return Reaction::ignored();
  }
}

Reaction TearTool::wheel(const WheelEvent& event, const Scope&) {
  if (!event.modifiers.control || event.notches == 0 || !hasPath()) return Reaction::ignored();
  isOneLayer_ = event.notches < 0;
  hasAlt_ = false;
  return Reaction::handled();
}

std::optional<Proposal> TearTool::proposal(const Scope&) const {
  if (!hasPath()) return std::nullopt;
  TearStep tear;
  tear.path = {Frame::Paper, path_};
  if (isOneLayer_ || hasAlt_) {
    ChosenLayers chosen;
    for (const Vec2 place : besides_) chosen.facets.push_back({Frame::Paper, place});
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
  Marks marks;
  const auto spotAt = [&](Vec2 place, std::size_t edge) {
    const auto facet = facetAt(state.pattern, edge < besides_.size() ? besides_[edge] : place);
    return facet ? std::optional<Spot>(Spot{*facet, place}) : std::nullopt;
  };
  if (hovered_ && phase_ != Phase::Dragging && phase_ != Phase::Clicking) {
    markHinges(state, *hovered_, marks);
    if (const auto spot = spotAt(*hovered_, besides_.size()))
      marks.push_back(PointMark{MarkRole::Hovered, *spot});
  }
  if (!isBusy()) return marks;
  if (phase_ != Phase::Resting) markHinges(state, path_.back(), marks);
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
    const auto a = spotAt(path_[i], i);
    const auto b = spotAt(path_[i + 1], i);
    if (a && b) marks.push_back(PathMark{MarkRole::Line, {*a, *b}, false, false});
  }
  const std::size_t last = besides_.empty() ? 0 : besides_.size() - 1;
  if (const auto spot = spotAt(path_.front(), 0))
    marks.push_back(PointMark{MarkRole::Handle, *spot});
  if (const auto spot = spotAt(path_.back(), last); spot && hasPath())
    marks.push_back(PointMark{MarkRole::ActiveHandle, *spot});
  return marks;
}

double TearTool::lengthOfPath() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) sum += distance(path_[i], path_[i + 1]);
  return sum;
}

std::vector<Field> TearTool::fields(const Scope&) const {
  std::vector<Field> fields;
  if (!hasPath()) return fields;
  Field size;
  size.id = "length";
  size.label = {KIRI_TEXT("editor/tools", "Length"), {}};
  size.value = lengthOfPath();
  size.most = lengthOfPath() - distance(path_[path_.size() - 2], path_.back()) +
              distance(path_[path_.size() - 2], farEnd_);
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
  const double pick = scope.state->tolerance().pick();
  if (!hasPath() || !(value.number > pick)) return Reaction::handled();
  double left = value.number;
  std::size_t i = 0;
  while (i + 2 < path_.size() && left > distance(path_[i], path_[i + 1]) + pick) {
    left -= distance(path_[i], path_[i + 1]);
    ++i;
  }
  if (i + 2 < path_.size()) farEnd_ = path_[i + 1];
  const double most = distance(path_[i], farEnd_);
  const Vec2 end = left >= most ? farEnd_ : lerp(path_[i], farEnd_, left / most);
  path_.resize(i + 1);
  path_.push_back(end);
  besides_.resize(i + 1);
  std::vector<Vec2> anchors;
  for (const Vec2 anchor : anchors_) {
    if (std::find(path_.begin(), path_.end(), anchor) != path_.end()) anchors.push_back(anchor);
  }
  anchors_ = std::move(anchors);
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
