// Poses, pieces and measures of a state.
// SPDX-License-Identifier: MIT
#include "core/paper/folded_state.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

/// Pose of the facet across a hinge: T_right = T_left * Rot(hinge, -angle).
Rigid poseAcross(const CreasePattern& pattern, const Edge& edge, const Rigid& pose, bool fromLeft) {
  if (edge.angle == 0) return pose;
  const Vec2 a = pattern[edge.from];
  const Vec2 u = normalized(pattern[edge.to] - a);
  const double degrees = fromLeft ? -edge.angle : edge.angle;
  return compose(pose, rotationAbout({a.x, a.y, 0}, {u.x, u.y, 0}, degrees));
}

/// Calls visit(edge, facet, neighbour) over all hinges, breadth first from the facets in `queue`.
template <class Visit>
void spread(const CreasePattern& pattern, std::vector<FacetId> queue, std::vector<bool>& isSeen,
            Visit visit) {
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const FacetId facet = queue[i];
    for (const EdgeUse use : pattern[facet].border) {
      const Edge& edge = pattern[use.edge];
      if (edge.kind != EdgeKind::Hinge) continue;
      const FacetId next = across(edge, facet);
      if (isSeen[next.index]) continue;
      isSeen[next.index] = true;
      visit(edge, facet, next);
      queue.push_back(next);
    }
  }
}

}  // namespace

FoldedState flatState(const Sheet& sheet) {
  FoldedState state(patternOf(sheet));
  state.rests = {{FacetId(0), Rigid{}}};
  state.poses = {Rigid{}};
  state.layers = LayerOrder({{{0, 0, 1}, {FacetId(0)}, {}}});
  return state;
}

std::vector<Rigid> derivePoses(const CreasePattern& pattern, const std::vector<Rest>& rests) {
  std::vector<Rigid> poses(pattern.facets.size());
  std::vector<bool> isSeen(pattern.facets.size(), false);
  for (const Rest& rest : rests) {
    if (isSeen[rest.facet.index]) continue;
    isSeen[rest.facet.index] = true;
    poses[rest.facet.index] = rest.pose;
    spread(pattern, {rest.facet}, isSeen, [&](const Edge& edge, FacetId facet, FacetId next) {
      poses[next.index] = poseAcross(pattern, edge, poses[facet.index], edge.left == facet);
    });
  }
  KIRI_CHECK(std::find(isSeen.begin(), isSeen.end(), false) == isSeen.end(),
             "every piece of paper has a rest");
  return poses;
}

std::vector<std::uint32_t> piecesOf(const CreasePattern& pattern) {
  std::vector<std::uint32_t> piece(pattern.facets.size(), 0);
  std::vector<bool> isSeen(pattern.facets.size(), false);
  std::uint32_t count = 0;
  for (std::size_t f = 0; f < pattern.facets.size(); ++f) {
    if (isSeen[f]) continue;
    isSeen[f] = true;
    piece[f] = count;
    spread(pattern, {FacetId(f)}, isSeen,
           [&](const Edge&, FacetId, FacetId next) { piece[next.index] = count; });
    ++count;
  }
  return piece;
}

double stretchOf(const FoldedState& state) {
  double worst = 0;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    for (const VertexId v : {edge.from, edge.to}) {
      const Vec2 p = state.pattern[v];
      worst = std::max(
          worst, distance(state.poseOf(edge.left).apply(p), state.poseOf(edge.right).apply(p)));
    }
  }
  return worst;
}

bool isFlat(const FoldedState& state) {
  return std::all_of(state.pattern.edges.begin(), state.pattern.edges.end(), [](const Edge& edge) {
    return edge.kind != EdgeKind::Hinge || edge.angle == 0 || std::abs(edge.angle) == 180;
  });
}

std::optional<double> amountOf(const FoldedState& state, FoldLineId line) {
  std::optional<double> amount;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || edge.line != line) continue;
    const double here = edge.sign * edge.angle;
    if (amount && std::abs(*amount - here) > kSameAngle) return std::nullopt;
    amount = here;
  }
  return amount;
}

}  // namespace kiri
