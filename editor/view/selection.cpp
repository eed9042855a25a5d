// Adding to and taking from the selection; what it means in a state.
// SPDX-License-Identifier: MIT
#include "editor/view/selection.h"

#include <algorithm>

namespace kiri {

void Selection::toggle(const Selected& item) {
  const auto at = std::find(items_.begin(), items_.end(), item);
  if (at == items_.end()) {
    items_.push_back(item);
  } else {
    items_.erase(at);
  }
}

bool Selection::drop(SelectedKind kind) {
  const auto isOfKind = [kind](const Selected& item) { return item.kind == kind; };
  const auto kept = std::remove_if(items_.begin(), items_.end(), isOfKind);
  const bool wasThere = kept != items_.end();
  items_.erase(kept, items_.end());
  return wasThere;
}

std::vector<Vec2> Selection::placesOf(SelectedKind kind) const {
  std::vector<Vec2> places;
  for (const Selected& item : items_) {
    if (item.kind == kind) places.push_back(item.place);
  }
  return places;
}

std::optional<Selected> Selection::lastLine() const {
  const auto at = std::find_if(items_.rbegin(), items_.rend(), [](const Selected& item) {
    return item.kind == SelectedKind::Line;
  });
  if (at == items_.rend()) return std::nullopt;
  return *at;
}

Selected selectedFacet(const FoldedState& state, FacetId facet) {
  return {SelectedKind::Facet, interiorPointOf(state.pattern, facet), {}, {}};
}

Selected selectedVertex(const FoldedState& state, VertexId vertex) {
  return {SelectedKind::Vertex, state.pattern[vertex], {}, {}};
}

Selected selectedLine(const FoldedState& state, EdgeId edge) {
  const Arc arc = arcOf(state.pattern, edge);
  return {SelectedKind::Line, pointAt(arc, 0.5), arc.start, arc.end};
}

std::vector<FacetId> facetsOf(const FoldedState& state, const Selection& selection) {
  std::vector<FacetId> facets;
  for (const Vec2 place : selection.placesOf(SelectedKind::Facet)) {
    if (const std::optional<FacetId> facet = facetAt(state.pattern, place)) {
      facets.push_back(*facet);
    }
  }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

}  // namespace kiri
