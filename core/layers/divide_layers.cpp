// SPDX-License-Identifier: MIT
#include "core/layers/divide_layers.h"

#include "core/layers/refine.h"

namespace kiri {

Result<std::size_t> divideLayers(FoldedState& state, const std::vector<FacetId>& facets,
                                 const Inscribed& inscribed) {
  std::size_t count = 0;
  std::vector<FacetId> origin;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) origin.push_back(FacetId(f));
  for (const FacetId facet : facets) {
    Result<std::vector<NewEdge>> edges = inscribed(state.pattern, facet);
    if (!edges) return edges.error();
    count += edges->size();
    for (const FacetId made : divideFacet(state.pattern, facet, *edges)) {
      if (made == facet) continue;
      origin.push_back(facet);
      state.poses.push_back(state.poses[facet.index]);
    }
  }
  state.layers = refined(state.layers, origin);
  return count;
}

}  // namespace kiri
