// SPDX-License-Identifier: MIT
#include "editor/tools/tear_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/snap/fold_ends.h"
#include "editor/tools/drawn_line.h"

namespace kiri {
namespace {

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

Vec2 besideOf(const FoldedState& state, EdgeId edge) {
  return interiorPointOf(state.pattern, state.pattern[edge].left);
}

/// What the pointer means on the graph: a point of an edge that has been reached, or its vertex.
struct Aim {
  EdgeHit hit;
  std::optional<VertexId> vertex;
  Marks caught;
};

/// Of edges that lie on each other the one is meant that the tear comes to first. Where no edge is
/// seen within `near` pixels, one is meant that is led along under other paper.
std::optional<EdgeHit> nearestReached(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                      double near, const HingeGraph::Ways& ways) {
  const auto isReached = [&](EdgeId e) {
    const Edge& edge = state.pattern[e];
    return edge.kind == EdgeKind::Hinge && std::isfinite(ways.far[edge.from.index]);
  };
  std::vector<EdgeHit> hits = edgesUnder(state, map, pixels, HUGE_VAL, isReached);
  if (hits.empty() || hits.front().pixels > 2 * near) {
    std::vector<EdgeHit> hidden = edgesUnder(state, map, pixels, near, isReached, true);
    if (!hidden.empty()) hits = std::move(hidden);
  }
  std::optional<EdgeHit> best;
  double least = 0;
  for (const EdgeHit& hit : hits) {
    const Edge& edge = state.pattern[hit.edge];
    const double far = std::min(ways.far[edge.from.index], ways.far[edge.to.index]);
    if (best && far >= least) continue;
    best = hit;
    least = far;
  }
  return best;
}

std::optional<Aim> aimOf(const PointerEvent& event, const Scope& scope,
                         const HingeGraph::Ways& ways) {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(event.pane);
  const auto hit = nearestReached(state, map, event.at, handleReach(event), ways);
  if (!hit) return std::nullopt;
  Aim aim{*hit, std::nullopt, {}};
  const Edge& edge = state.pattern[hit->edge];
  // A handle's reach around each vertex means the vertex.
  const VertexId nearest = hit->t < 0.5 ? edge.from : edge.to;
  const Vec2 end = map.toPixels(state, {edge.left, state.pattern[nearest]});
  if (distance(end, map.toPixels(state, {edge.left, hit->paper})) <= handleReach(event)) {
    aim.vertex = nearest;
    return aim;
  }
  if (!scope.snaps.isOn) return aim;
  const Arc line = Arc::line(state.pattern[edge.from], state.pattern[edge.to]);
  const auto takes = [&](const std::optional<Snapped>& caught) {
    if (!caught || caught->kind == SnapKind::None || caught->kind == SnapKind::Edge) return false;
    const Nearest there = nearestOn(line, caught->spot.paper);
    if (there.distance > state.tolerance().pick()) return false;
    aim.hit.t = there.t;
    aim.hit.paper = caught->spot.paper;
    aim.caught = caught->marks;
    return true;
  };
  // Else where the folds are likely to end for which the paper is torn.
  if (!takes(snapPoint(state, map, event.at, scope.snaps, edge.left)))
    takes(snapToFoldEnd(state, map, event.at, scope.snaps, hit->edge));
  return aim;
}

}  // namespace

void TearPath::begin(Vec2 vertex) {
  anchors_ = points_ = {vertex};
  besides_.clear();
  farEnd_ = vertex;
  caught_.clear();
}

bool TearPath::follow(const PointerEvent& event, const Scope& scope, bool isDragging) {
  const FoldedState& state = *scope.state;
  const HingeGraph graph(state);
  std::vector<VertexId> walk;
  HingeGraph::Ways ways;
  for (const Vec2 place : anchors_) {
    const auto anchor = vertexAt(state.pattern, place);
    if (!anchor) return false;
    const std::vector<VertexId> more =
        walk.empty() ? std::vector<VertexId>{*anchor} : ways.to(*anchor);
    walk.insert(walk.end(), more.begin(), more.end());
    ways = graph.from(*anchor);
  }
  const auto aim = aimOf(event, scope, ways);
  caught_.clear();
  if (!aim) return true;
  caught_ = aim->caught;
  VertexId target;
  if (aim->vertex) {
    target = *aim->vertex;
  } else {
    const Edge& edge = state.pattern[aim->hit.edge];
    const auto farBy = [&](VertexId v) {
      return ways.far[v.index] + distance(state.pattern[v], aim->hit.paper);
    };
    target = farBy(edge.from) <= farBy(edge.to) ? edge.from : edge.to;
  }
  const std::vector<VertexId> more = ways.to(target);
  walk.insert(walk.end(), more.begin(), more.end());
  take(state, graph, withoutLoops(walk), aim->hit, aim->vertex.has_value());
  if (isDragging && aim->vertex && anchors_.back() != points_.back())
    anchors_.push_back(points_.back());
  return true;
}

void TearPath::take(const FoldedState& state, const HingeGraph& graph, std::vector<VertexId> way,
                    const EdgeHit& hit, bool isAtVertex) {
  const CreasePattern& pattern = state.pattern;
  const Edge& last = pattern[hit.edge];
  const auto isLast = [&](VertexId a, VertexId b) {
    return (a == last.from && b == last.to) || (a == last.to && b == last.from);
  };
  // Back on the edge that the walk came along: the path ends inside it.
  if (!isAtVertex && way.size() > 1 && isLast(way[way.size() - 2], way.back())) way.pop_back();
  points_ = {pattern[way.front()]};
  besides_.clear();
  for (std::size_t i = 1; i < way.size(); ++i) {
    points_.push_back(pattern[way[i]]);
    for (const EdgeId e : graph.at(way[i - 1])) {
      if (graph.otherEnd(e, way[i - 1]) != way[i]) continue;
      besides_.push_back(besideOf(state, e));
      break;
    }
  }
  farEnd_ = points_.back();
  if (!isAtVertex && distance(points_.back(), hit.paper) > state.tolerance().pick()) {
    farEnd_ = pattern[way.back() == last.from ? last.to : last.from];
    points_.push_back(hit.paper);
    besides_.push_back(besideOf(state, hit.edge));
  }
  keepAnchorsOnPath();
}

void TearPath::keepAnchorsOnPath() {
  const auto isOff = [&](Vec2 anchor) {
    return std::find(points_.begin(), points_.end(), anchor) == points_.end();
  };
  anchors_.erase(std::remove_if(anchors_.begin(), anchors_.end(), isOff), anchors_.end());
}

bool TearPath::anchorEnd(const FoldedState& state) {
  if (anchors_.back() == points_.back() || !vertexAt(state.pattern, points_.back())) return false;
  anchors_.push_back(points_.back());
  return true;
}

bool TearPath::dropAnchor() {
  if (anchors_.size() < 2) return false;
  anchors_.pop_back();
  const auto end = std::find(points_.begin(), points_.end(), anchors_.back());
  points_.resize(static_cast<std::size_t>(end - points_.begin()) + 1);
  besides_.resize(points_.size() - 1);
  farEnd_ = points_.back();
  return true;
}

double TearPath::length() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) sum += distance(points_[i], points_[i + 1]);
  return sum;
}

double TearPath::mostLength() const {
  if (!isThere()) return 0;
  const Vec2 from = points_[points_.size() - 2];
  return length() - distance(from, points_.back()) + distance(from, farEnd_);
}

void TearPath::setLength(double length, double resolution) {
  if (!isThere() || !(length > resolution)) return;
  double left = length;
  std::size_t i = 0;
  while (i + 2 < points_.size() && left > distance(points_[i], points_[i + 1]) + resolution) {
    left -= distance(points_[i], points_[i + 1]);
    ++i;
  }
  if (i + 2 < points_.size()) farEnd_ = points_[i + 1];
  const double most = distance(points_[i], farEnd_);
  const Vec2 end = left >= most ? farEnd_ : lerp(points_[i], farEnd_, left / most);
  points_.resize(i + 1);
  points_.push_back(end);
  besides_.resize(i + 1);
  keepAnchorsOnPath();
}

}  // namespace kiri
