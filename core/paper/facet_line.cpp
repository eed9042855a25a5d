// A segment drawn on one facet, and the same segment on the facets that lie in its plane.
// SPDX-License-Identifier: MIT
#include "core/paper/facet_line.h"

namespace kiri {

FacetLine lineOn(const FoldedState& state, const FacetLine& line, FacetId facet) {
  if (facet == line.facet) return line;
  const Rigid& from = state.poseOf(line.facet);
  const Rigid& to = state.poseOf(facet);
  return {facet, to.pullBack(from.apply(line.from)), to.pullBack(from.apply(line.to))};
}

}  // namespace kiri
