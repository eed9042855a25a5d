// A facet that shares no edge with others.
// SPDX-License-Identifier: MIT
#include "core/paper/loose_facet.h"

#include <utility>

namespace kiri {

FacetId addLooseFacet(CreasePattern& pattern, std::span<const Vec2> corners) {
  const FacetId id(pattern.facets.size());
  const std::size_t first = pattern.vertices.size();
  Facet facet;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    pattern.vertices.push_back(corners[i]);
    Edge side;
    side.from = VertexId(first + i);
    side.to = VertexId(first + (i + 1) % corners.size());
    side.left = id;
    facet.border.push_back({EdgeId(pattern.edges.size()), false});
    pattern.edges.push_back(side);
  }
  pattern.facets.push_back(std::move(facet));
  return id;
}

}  // namespace kiri
