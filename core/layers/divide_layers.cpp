// SPDX-License-Identifier: MIT
#include "core/layers/divide_layers.h"

#include <optional>

#include "core/base/text.h"
#include "core/layers/refine.h"

namespace kiri {

namespace {

/// A place on the border of a facet that is thinner than a crease may leave paper, if it is.
std::optional<Vec2> thinPlace(const CreasePattern& pattern, FacetId facet) {
  double doubled = 0;
  double around = 0;
  const Vec2 base = pattern[startOf(pattern, pattern[facet].border.front())];
  for (const EdgeUse use : pattern[facet].border) {
    const Vec2 a = pattern[startOf(pattern, use)] - base;
    const Vec2 b = pattern[endOf(pattern, use)] - base;
    around += distance(a, b);
    if (!pattern[use.edge].isCurved()) {
      doubled += cross(a, b);
      continue;
    }
    const Arc arc = arcOf(pattern, use);
    doubled += doubleArea(Arc::cubic(a, arc.control1 - base, arc.control2 - base, b));
  }
  if (doubled > pattern.tolerance.thin() * around) return std::nullopt;  // width = 2 area / around
  return pointAt(arcOf(pattern, pattern[facet].border.front()), 0.5);
}

Error tooThin(Vec2 place) {
  return {ErrorCode::TooThin,
          "the line leaves only a sliver of paper at " + text(place) +
              " mm; draw it farther in, or past the paper there",
          {{place}, {}, {}}};
}

}  // namespace

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
      if (edges->empty()) continue;
      if (const auto place = thinPlace(state.pattern, made)) return tooThin(*place);
      if (made == facet) continue;
      origin.push_back(facet);
      state.poses.push_back(state.poses[facet.index]);
    }
  }
  state.layers = refined(state.layers, origin);
  return count;
}

}  // namespace kiri
