// SPDX-License-Identifier: MIT
#include "core/cut/tear.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/cut/edge_stretch.h"
#include "core/cut/rests.h"
#include "core/layers/hinge_conflicts.h"
#include "core/layers/topmost.h"

namespace kiri {
namespace {

/// Where the two ends of an edge are seen.
EdgeEnds endsOf(const FoldedState& state, const Edge& edge, bool onPaper, bool isSeenFlat) {
  const Vec2 a = state.pattern[edge.from];
  const Vec2 b = state.pattern[edge.to];
  if (onPaper) return {{a.x, a.y, 0}, {b.x, b.y, 0}};
  const Rigid& pose = state.poseOf(edge.left);
  EdgeEnds ends{pose.apply(a), pose.apply(b)};
  if (isSeenFlat) {
    ends.from.z = 0;
    ends.to.z = 0;
  }
  return ends;
}

class EdgeFinder {
 public:
  EdgeFinder(const FoldedState& state, EdgeKind kind, const EdgeChoice& choice)
      : state_(state), kind_(kind), choice_(choice) {}

  /// Stretches along one segment of the path, after the choice of layers; each edge at most once.
  std::vector<Stretch> along(Vec2 p, Vec2 q, bool isOnPaper) const {
    std::vector<Stretch> found = search({p.x, p.y, 0}, {q.x, q.y, 0}, isOnPaper, true);
    const bool meansAll = !choice_.top && !choice_.ofFacets && !choice_.isOwnOnly;
    if (isOnPaper && (meansAll || choice_.top)) found = withOtherLayers(found);
    return chosen(std::move(found));
  }

 private:
  std::vector<Stretch> search(Vec3 p, Vec3 q, bool onPaper, bool seenFlat) const {
    std::vector<Stretch> found;
    for (std::size_t e = 0; e < state_.pattern.edges.size(); ++e) {
      const Edge& edge = state_.pattern.edges[e];
      if (edge.kind != kind_) continue;
      const auto stretch = stretchAlong(EdgeId(e), endsOf(state_, edge, onPaper, seenFlat), p, q,
                                        state_.tolerance());
      if (stretch) found.push_back(*stretch);
    }
    return found;
  }

  /// The edges of other layers that lie where these lie in the model.
  std::vector<Stretch> withOtherLayers(const std::vector<Stretch>& first) const {
    std::vector<Stretch> all = first;
    for (const Stretch& stretch : first) {
      const auto [a, b] = endsOf(state_, state_.pattern[stretch.edge], false, false);
      const Vec3 p = a + (b - a) * stretch.t0;
      const Vec3 q = a + (b - a) * stretch.t1;
      for (Stretch other : search(p, q, false, false)) {
        const bool isKnown = std::any_of(all.begin(), all.end(),
                                         [&](const Stretch& s) { return s.edge == other.edge; });
        if (isKnown) continue;
        other.from += stretch.from;
        other.to += stretch.from;
        all.push_back(other);
      }
    }
    return all;
  }

  double heightOf(EdgeId id) const {
    const Edge& edge = state_.pattern[id];
    double height = 0;
    for (const FacetId f : {edge.left, edge.right}) {
      const LayerSet& set = state_.layers.sets()[state_.layers.setOf(f)];
      const double rank = state_.layers.rankOf(f);
      height = std::max(
          height, set.normal.z < 0 ? static_cast<double>(set.upward.size()) - 1 - rank : rank);
    }
    return height;
  }

  std::vector<Stretch> chosen(std::vector<Stretch> found) const {
    std::vector<Stretch> result;
    if (choice_.ofFacets) {
      const auto& facets = *choice_.ofFacets;
      const auto isMeant = [&](FacetId f) {
        return std::find(facets.begin(), facets.end(), f) != facets.end();
      };
      for (const Stretch& s : found) {
        const Edge& edge = state_.pattern[s.edge];
        if (isMeant(edge.left) || isMeant(edge.right)) result.push_back(s);
      }
      return result;
    }
    if (!choice_.top) return found;
    std::vector<Cover> covers;
    for (std::size_t i = 0; i < found.size(); ++i) {
      covers.push_back({i, found[i].from, found[i].to, heightOf(found[i].edge)});
    }
    for (const std::size_t i : topmost(covers, *choice_.top, state_.tolerance().match()))
      result.push_back(found[i]);
    return result;
  }

  const FoldedState& state_;
  EdgeKind kind_;
  const EdgeChoice& choice_;
};

/// The angle of a hinge that joins its facets as they lie.
double angleBetween(const FoldedState& state, const Edge& edge) {
  const Rigid& left = state.poseOf(edge.left);
  const Vec3 normal = state.poseOf(edge.right).normal();
  const Vec2 u = normalized(state.pattern[edge.to] - state.pattern[edge.from]);
  const double c = dot(normal, left.normal());
  const double s = -dot(normal, left.direction(-perpendicular(u)));
  if (c < 0 && std::abs(s) <= kSamePlane) {
    const LayerSet& set = state.layers.sets()[state.layers.setOf(edge.left)];
    const bool rightIsAbove = state.layers.isAbove(edge.right, edge.left);
    const bool leftFrontIsUp = dot(left.normal(), set.normal) > 0;
    return rightIsAbove == leftFrontIsUp ? 180 : -180;
  }
  if (c > 0 && std::abs(s) <= kSamePlane) return 0;
  return angleDegrees(c, s);
}

/// A hinge of a fold line that comes back folded against its line (a tuck) belongs to the line that
/// way round from now on, so that the line unfolds and refolds as a whole.
void turnWithLine(const FoldedState& state, Edge& edge) {
  if (!edge.line.isValid() || edge.angle == 0) return;
  const bool isPositive = state.lines[edge.line.index].foldedAmount > 0;
  if ((edge.sign * edge.angle > 0) != isPositive) edge.sign = static_cast<std::int8_t>(-edge.sign);
}

Error noEdge(EdgeKind kind, Vec2 p, Vec2 q) {
  const std::string what = kind == EdgeKind::Hinge ? "no crease or edge lies" : "no torn edge lies";
  const std::string remedy =
      kind == EdgeKind::Hinge ? "; add an edge there first" : "; nothing is to be mended there";
  return {ErrorCode::NothingToDo,
          what + " along the path from " + text(p) + " to " + text(q) + " mm in the chosen layers" +
              remedy,
          {{p, q}, {{p, q}}, {}}};
}

bool doSidesLieTogether(const FoldedState& state, const Edge& edge) {
  const auto gap = [&](VertexId v) {
    const Vec2 p = state.pattern[v];
    return distance(state.poseOf(edge.left).apply(p), state.poseOf(edge.right).apply(p));
  };
  const double tol = state.tolerance().match();
  return gap(edge.from) <= tol && gap(edge.to) <= tol;
}

/// The edges of the kind along the path, each divided to just that stretch.
Result<std::vector<EdgeId>> takeEdges(FoldedState& state, EdgeKind kind, const EdgePath& path,
                                      const EdgeChoice& choice) {
  std::vector<EdgeId> edges;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Vec2 p = path.points[i];
    const Vec2 q = path.points[i + 1];
    const std::vector<Stretch> stretches =
        EdgeFinder(state, kind, choice).along(p, q, path.isOnPaper);
    if (stretches.empty()) return noEdge(kind, p, q);
    for (const Stretch& stretch : stretches) edges.push_back(isolate(state.pattern, stretch));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

Error apart(const FoldedState& state, const Edge& edge) {
  const Vec2 a = state.pattern[edge.from];
  const Vec2 b = state.pattern[edge.to];
  return {ErrorCode::CannotMend,
          "the torn edge from " + text(a) + " to " + text(b) +
              " mm cannot be mended: its two sides have moved apart; fold or unfold them back "
              "together first",
          {{a, b}, {{a, b}}, {}}};
}

Error blocked(const FoldedState& state, const Edge& edge, FacetId between) {
  const Vec2 a = state.pattern[edge.from];
  const Vec2 b = state.pattern[edge.to];
  const Vec2 p = interiorPointOf(state.pattern, between);
  return {ErrorCode::CannotMend,
          "the torn edge from " + text(a) + " to " + text(b) +
              " mm cannot be mended: the layer at " + text(p) +
              " mm on the sheet lies between its two sides; fold that layer away first",
          {{a, b, p}, {{a, b}}, {p}}};
}

/// Paper that a hinge would pass through if it held together.
std::optional<FacetId> inTheWay(const FoldedState& state, EdgeId id) {
  const Edge& edge = state.pattern[id];
  for (const FacetId side : {edge.left, edge.right}) {
    const std::vector<HingeConflict> found = hingeConflicts(
        state.pattern, state.poses, state.layers, state.layers.setOf(side), {{}, 1, id});
    if (found.empty()) continue;
    const FacetId first = found.front().first[0];
    const bool isOwn = first == edge.left || first == edge.right;
    return isOwn ? found.front().second[0] : first;
  }
  return std::nullopt;
}

}  // namespace

Result<FoldedState> tear(const FoldedState& state, const EdgePath& path, const EdgeChoice& choice) {
  FoldedState next = state;
  const Result<std::vector<EdgeId>> edges = takeEdges(next, EdgeKind::Hinge, path, choice);
  if (!edges) return edges.error();
  for (const EdgeId id : *edges) next.pattern[id].kind = EdgeKind::Tear;
  renewRests(next);
  return next;
}

Result<FoldedState> mend(const FoldedState& state, const EdgePath& path, const EdgeChoice& choice) {
  FoldedState next = state;
  std::vector<EdgeId> edges;
  const bool meansAll = path.points.empty();
  if (meansAll) {
    for (std::size_t e = 0; e < next.pattern.edges.size(); ++e) {
      const Edge& edge = next.pattern.edges[e];
      if (edge.kind == EdgeKind::Tear && doSidesLieTogether(next, edge)) edges.push_back(EdgeId(e));
    }
    if (edges.empty()) {
      return Error{ErrorCode::NothingToDo,
                   "there is no torn edge whose two sides lie together, so nothing can be mended",
                   {}};
    }
  } else {
    Result<std::vector<EdgeId>> found = takeEdges(next, EdgeKind::Tear, path, choice);
    if (!found) return found.error();
    edges = std::move(*found);
  }
  for (const EdgeId id : edges) {
    Edge& edge = next.pattern[id];
    if (!doSidesLieTogether(next, edge)) return apart(next, edge);
    edge.angle = angleBetween(next, edge);
    edge.kind = EdgeKind::Hinge;
    turnWithLine(next, edge);
  }
  renewRests(next);
  for (const EdgeId id : edges) {
    const Edge& edge = next.pattern[id];
    if (const auto between = inTheWay(next, id)) return blocked(next, edge, *between);
  }
  return next;
}

}  // namespace kiri
