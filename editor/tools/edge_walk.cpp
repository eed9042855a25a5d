// SPDX-License-Identifier: MIT
#include "editor/tools/edge_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include "editor/view/picking.h"

namespace kiri {
namespace {

/// Where a facet's side of an edge comes nearest to the pointer.
struct Projected {
  EdgeHit hit;
  FacetId side;
  Vec2 at;  ///< pixels
};

Projected nearestOn(const FoldedState& state, const PaneMap& map, EdgeId id, FacetId side,
                    Vec2 pixels) {
  const Edge& edge = state.pattern[id];
  const Vec2 a = state.pattern[edge.from];
  const Vec2 b = state.pattern[edge.to];
  const Vec2 p = map.toPixels(state, {side, a});
  const Vec2 way = map.toPixels(state, {side, b}) - p;
  const double size = dot(way, way);
  const double along = size > 0 ? std::clamp(dot(pixels - p, way) / size, 0.0, 1.0) : 0;
  const Vec2 at = p + way * along;
  // In perspective, equal parts of the picture are not equal parts of the paper.
  double t = along;
  if (along > 0 && along < 1) {
    const auto place = map.onPlaneOf(state, side, at);
    if (place) t = std::clamp(dot(*place - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  }
  return {{id, t, lerp(a, b, t), distance(at, pixels)}, side, at};
}

/// The paper that is seen on both sides of a point of an edge; edges that lie on each other ask for
/// the same.
class SeenBeside {
 public:
  SeenBeside(const FoldedState& state, const PaneMap& map) : state_(state), map_(map) {}

  /// Whether one of the edge's facets is seen beside it there.
  bool has(const Projected& here) {
    const Edge& edge = state_.pattern[here.hit.edge];
    const Vec2 a = map_.toPixels(state_, {here.side, state_.pattern[edge.from]});
    const Vec2 way = map_.toPixels(state_, {here.side, state_.pattern[edge.to]}) - a;
    if (length(way) < kAside) return false;  // seen end-on
    const Vec2 along = normalized(way);
    // Away from the ends, where other edges go off.
    const double at = std::clamp(dot(here.at - a, along), std::min(2 * kAside, length(way) / 2),
                                 std::max(length(way) - 2 * kAside, length(way) / 2));
    const Look& seen = look(a + along * at, along);
    return std::any_of(seen.facets.begin(), seen.facets.end(),
                       [&](const auto& f) { return f && (*f == edge.left || *f == edge.right); });
  }
  std::size_t looks() const { return looks_.size(); }

 private:
  struct Look {
    Vec2 at;
    Vec2 along;
    std::array<std::optional<FacetId>, 2> facets;
  };

  const Look& look(Vec2 at, Vec2 along) {
    constexpr double kSame = 1.0 / 16;
    for (const Look& look : looks_) {
      if (distance(at, look.at) < kSame && std::abs(cross(along, look.along)) < kSame) return look;
    }
    Look look{at, along, {}};
    for (std::size_t i = 0; i < look.facets.size(); ++i) {
      const Vec2 aside = perpendicular(along) * (i == 0 ? kAside : -kAside);
      const auto pick = pickPaper(state_, map_, at + aside);
      if (pick) look.facets[i] = pick->spot.facet;
    }
    looks_.push_back(look);
    return looks_.back();
  }

  static constexpr double kAside = 1.5;  ///< pixels
  const FoldedState& state_;
  const PaneMap& map_;
  std::vector<Look> looks_;
};

}  // namespace

std::vector<EdgeHit> edgesUnder(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                double reach, const std::function<bool(EdgeId)>& isMeant,
                                bool hiddenToo) {
  constexpr double kSamePlace = 0.75;
  constexpr std::size_t kMostLooks = 24;
  std::vector<Projected> near;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.isCurved() || !isMeant(EdgeId(e))) continue;
    for (const FacetId side : {edge.left, edge.right}) {
      if (!side.isValid()) continue;
      const Projected here = nearestOn(state, map, EdgeId(e), side, pixels);
      if (here.hit.pixels <= reach) near.push_back(here);
    }
  }
  std::stable_sort(near.begin(), near.end(), [](const Projected& a, const Projected& b) {
    return a.hit.pixels < b.hit.pixels;
  });
  std::vector<EdgeHit> hits;
  std::optional<Vec2> at;
  SeenBeside seen(state, map);
  for (const Projected& here : near) {
    if (!at && !hiddenToo) {
      if (seen.looks() > kMostLooks) break;
      if (!seen.has(here)) continue;
    }
    if (!at) at = here.at;
    if (distance(here.at, *at) > kSamePlace) break;
    const bool isKnown = std::any_of(hits.begin(), hits.end(),
                                     [&](const EdgeHit& h) { return h.edge == here.hit.edge; });
    if (!isKnown) hits.push_back(here.hit);
  }
  return hits;
}

HingeGraph::HingeGraph(const FoldedState& state)
    : pattern_(state.pattern), edges_(state.pattern.vertices.size()) {
  for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
    const Edge& edge = pattern_.edges[e];
    if (edge.kind != EdgeKind::Hinge) continue;
    edges_[edge.from.index].push_back(EdgeId(e));
    edges_[edge.to.index].push_back(EdgeId(e));
  }
}

VertexId HingeGraph::otherEnd(EdgeId edge, VertexId vertex) const {
  return pattern_[edge].from == vertex ? pattern_[edge].to : pattern_[edge].from;
}

HingeGraph::Ways HingeGraph::from(VertexId start) const {
  const std::size_t count = pattern_.vertices.size();
  Ways ways{std::vector<double>(count, HUGE_VAL), std::vector<VertexId>(count)};
  using Reached = std::pair<double, std::uint32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  ways.far[start.index] = 0;
  open.emplace(0, start.index);
  while (!open.empty()) {
    const auto [far, index] = open.top();
    open.pop();
    if (far > ways.far[index]) continue;
    const VertexId vertex(index);
    for (const EdgeId edge : at(vertex)) {
      const VertexId next = otherEnd(edge, vertex);
      const double there = far + distance(pattern_[vertex], pattern_[next]);
      if (there >= ways.far[next.index]) continue;
      ways.far[next.index] = there;
      ways.previous[next.index] = vertex;
      open.emplace(there, next.index);
    }
  }
  return ways;
}

std::vector<VertexId> HingeGraph::Ways::to(VertexId vertex) const {
  std::vector<VertexId> way;
  for (VertexId v = vertex; previous[v.index].isValid(); v = previous[v.index]) way.push_back(v);
  std::reverse(way.begin(), way.end());
  return way;
}

std::optional<VertexId> vertexAt(const CreasePattern& pattern, Vec2 paper) {
  std::optional<VertexId> best;
  double nearest = pattern.tolerance.pick();
  for (const Edge& edge : pattern.edges) {
    for (const VertexId v : {edge.from, edge.to}) {
      const double away = distance(pattern[v], paper);
      if (away >= nearest) continue;
      nearest = away;
      best = v;
    }
  }
  return best;
}

bool canBeMended(const FoldedState& state, EdgeId id) {
  const Edge& edge = state.pattern[id];
  if (edge.kind != EdgeKind::Tear || !edge.left.isValid() || !edge.right.isValid()) return false;
  const double tol = state.tolerance().match();
  for (const VertexId v : {edge.from, edge.to}) {
    const Vec2 p = state.pattern[v];
    if (distance(state.poseOf(edge.left).apply(p), state.poseOf(edge.right).apply(p)) > tol)
      return false;
  }
  return true;
}

TornRun tornRunThrough(const FoldedState& state, EdgeId edge) {
  const CreasePattern& pattern = state.pattern;
  std::vector<std::vector<EdgeId>> torn(pattern.vertices.size());
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    if (pattern.edges[e].kind != EdgeKind::Tear) continue;
    torn[pattern.edges[e].from.index].push_back(EdgeId(e));
    torn[pattern.edges[e].to.index].push_back(EdgeId(e));
  }
  /// What follows behind one end of the edge.
  const auto walk = [&](VertexId end) {
    std::vector<std::pair<EdgeId, VertexId>> found;
    EdgeId last = edge;
    while (torn[end.index].size() == 2) {
      const auto& here = torn[end.index];
      const EdgeId next = here[0] == last ? here[1] : here[0];
      if (next == edge || !canBeMended(state, next)) break;
      end = pattern[next].from == end ? pattern[next].to : pattern[next].from;
      found.emplace_back(next, end);
      last = next;
    }
    return found;
  };
  TornRun run;
  const auto before = walk(pattern[edge].from);
  for (auto it = before.rbegin(); it != before.rend(); ++it) {
    run.points.push_back(pattern[it->second]);
    run.edges.push_back(it->first);
  }
  run.points.push_back(pattern[pattern[edge].from]);
  run.edges.push_back(edge);
  run.points.push_back(pattern[pattern[edge].to]);
  const bool isRing = !before.empty() && before.back().second == pattern[edge].to;
  if (isRing) return run;
  for (const auto& [next, end] : walk(pattern[edge].to)) {
    run.points.push_back(pattern[end]);
    run.edges.push_back(next);
  }
  return run;
}

}  // namespace kiri
