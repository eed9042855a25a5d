// SPDX-License-Identifier: MIT
#include "core/fold/hinges_along.h"

#include <algorithm>

#include "core/fold/moving_facets.h"

namespace kiri {

std::vector<EdgeId> hingesAlong(const FoldedState& state, const FacetLine& line) {
  const Rigid& frame = state.poseOf(line.facet);
  const Motion axis{frame.apply(line.from), normalized(frame.direction(line.to - line.from)), 0};
  const double span = distance(line.from, line.to);
  std::vector<EdgeId> along;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge || !liesOnAxis(state, edge, axis)) continue;
    const Rigid& pose = state.poseOf(edge.left);
    const double s = dot(pose.apply(state.pattern[edge.from]) - axis.point, axis.axis);
    const double t = dot(pose.apply(state.pattern[edge.to]) - axis.point, axis.axis);
    const double shared = std::min(span, std::max(s, t)) - std::max(0.0, std::min(s, t));
    if (shared > state.tolerance().length()) along.push_back(EdgeId(e));
  }
  return along;
}

}  // namespace kiri
