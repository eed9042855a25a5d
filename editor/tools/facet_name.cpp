// SPDX-License-Identifier: MIT
#include "editor/tools/facet_name.h"

namespace kiri {

std::optional<FacetId> FacetName::in(const FoldedState& state) const {
  if (lastSeen_.index < state.pattern.facets.size() &&
      locate(regionOf(state.pattern, lastSeen_), place_, 0) == Where::Inside)
    return lastSeen_;
  return facetAt(state.pattern, place_);
}

}  // namespace kiri
