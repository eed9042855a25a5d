// SPDX-License-Identifier: MIT
#include "core/fold/moving_facets.h"

#include <algorithm>

namespace kiri {
namespace {

double distanceToAxis(const Motion& axis, Vec3 p) {
  return length(cross(axis.axis, p - axis.point));
}

/// Facets joined to `seeds`, and the hinge through which each was reached.
struct Flood {
  std::vector<bool> isReached;
  std::vector<EdgeId> through;
};

Flood flood(const FoldedState& state, const Motion& axis, std::vector<FacetId> queue) {
  Flood result{std::vector<bool>(state.pattern.facets.size(), false),
               std::vector<EdgeId>(state.pattern.facets.size())};
  for (const FacetId f : queue) result.isReached[f.index] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const EdgeUse use : state.pattern[queue[i]].border) {
      const Edge& edge = state.pattern[use.edge];
      if (edge.kind != EdgeKind::Hinge) continue;
      const FacetId next = across(edge, queue[i]);
      if (result.isReached[next.index] || liesOnAxis(state, edge, axis)) continue;
      result.isReached[next.index] = true;
      result.through[next.index] = use.edge;
      queue.push_back(next);
    }
  }
  return result;
}

/// The hinges by which the flood came to a facet, from its seed on.
std::vector<EdgeId> wayTo(const FoldedState& state, const Flood& reached, FacetId facet) {
  std::vector<EdgeId> way;
  while (reached.through[facet.index].isValid()) {
    way.push_back(reached.through[facet.index]);
    facet = across(state.pattern[way.back()], facet);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

bool liesOnAxis(const FoldedState& state, const Edge& edge, const Motion& axis) {
  const Rigid& pose = state.poseOf(edge.left);
  const double tol = 2 * state.tolerance().length();
  return distanceToAxis(axis, pose.apply(state.pattern[edge.from])) <= tol &&
         distanceToAxis(axis, pose.apply(state.pattern[edge.to])) <= tol;
}

MovingSet movingFacets(const FoldedState& state, const Motion& axis,
                       const std::vector<FacetId>& seeds, const std::vector<FacetId>& fixedSeeds) {
  Flood reached = flood(state, axis, seeds);
  for (const FacetId fixed : fixedSeeds) {
    if (reached.isReached[fixed.index]) return {reached.isReached, wayTo(state, reached, fixed)};
  }
  return {std::move(reached.isReached), {}};
}

}  // namespace kiri
