// SPDX-License-Identifier: MIT
#include "editor/tools/seen_side.h"

#include "core/fold/fold.h"

namespace kiri {

Vec3 seenUp(const FoldedState& state, const PaneMap& map, const Spot& spot) {
  const Vec3 normal = state.poseOf(spot.facet).normal();
  return map.showsFront(state, spot) ? normal : -normal;
}

bool seesAsSteps(const FoldedState& state, const PaneMap& map, const Spot& spot) {
  return dot(seenUp(state, map, spot), upOf(state, spot.facet)) > 0;
}

FoldType turnedIf(FoldType type, bool isTurned) {
  if (!isTurned) return type;
  return type == FoldType::Valley ? FoldType::Mountain : FoldType::Valley;
}

double seenHeight(const FoldedState& state, FacetId facet, Vec3 up) {
  const LayerSet& set = state.layers.sets()[state.layers.setOf(facet)];
  const double rank = state.layers.rankOf(facet);
  return dot(set.normal, up) < 0 ? static_cast<double>(set.upward.size()) - 1 - rank : rank;
}

}  // namespace kiri
