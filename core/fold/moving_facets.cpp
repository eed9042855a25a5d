// SPDX-License-Identifier: MIT
#include "core/fold/moving_facets.h"

#include <algorithm>
#include <cmath>

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

/// The facets joined to `seeds` by hinges that `passes` lets through.
template <typename Passes>
std::vector<bool> joined(const FoldedState& state, std::vector<FacetId> seeds, Passes passes) {
  std::vector<bool> isReached(state.pattern.facets.size(), false);
  for (const FacetId f : seeds) isReached[f.index] = true;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    for (const EdgeUse use : state.pattern[seeds[i]].border) {
      const Edge& edge = state.pattern[use.edge];
      if (edge.kind != EdgeKind::Hinge) continue;
      const FacetId next = across(edge, seeds[i]);
      if (isReached[next.index] || !passes(edge, next)) continue;
      isReached[next.index] = true;
      seeds.push_back(next);
    }
  }
  return isReached;
}

/// Takes along paper that is rolled up: what hangs on moving paper only, by creases on the axis
/// that are folded right over, so that both their sides lie on the moving side.
void takeRolledUp(const FoldedState& state, const Motion& axis,
                  const std::vector<FacetId>& fixedSeeds, std::vector<bool>& moves) {
  const std::vector<bool> rests =
      joined(state, fixedSeeds, [&](const Edge&, FacetId next) { return !moves[next.index]; });
  std::vector<FacetId> moving;
  for (std::size_t f = 0; f < moves.size(); ++f) {
    if (moves[f]) moving.push_back(FacetId(f));
  }
  const std::vector<bool> all = joined(state, moving, [&](const Edge& edge, FacetId next) {
    const bool isClosed = std::abs(edge.angle) >= 180 - kSameAngle;
    return !rests[next.index] && (isClosed || !liesOnAxis(state, edge, axis));
  });
  const bool isHeldElsewhere =
      std::any_of(state.pattern.edges.begin(), state.pattern.edges.end(), [&](const Edge& edge) {
        if (edge.kind != EdgeKind::Hinge || all[edge.left.index] == all[edge.right.index])
          return false;
        return !moves[(all[edge.left.index] ? edge.left : edge.right).index];
      });
  if (!isHeldElsewhere) moves = all;
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
  if (!fixedSeeds.empty()) takeRolledUp(state, axis, fixedSeeds, reached.isReached);
  return {std::move(reached.isReached), {}};
}

}  // namespace kiri
