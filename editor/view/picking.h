// What lies under the pointer.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "editor/view/pane_map.h"

namespace kiri {

/// Paper under the pointer.
struct PaperPick {
  Spot spot;
  Vec3 place;  ///< in the pane's space
  bool showsFront = true;
};

/// The paper that is seen at a pixel: nearest to the eye, in one plane the uppermost layer.
std::optional<PaperPick> pickPaper(const FoldedState& state, const PaneMap& map, Vec2 pixels);

/// All layers under a pixel, the one that is seen first.
std::vector<PaperPick> pickStack(const FoldedState& state, const PaneMap& map, Vec2 pixels);

struct VertexPick {
  VertexId vertex;
  Spot spot;  ///< the vertex on the facet under the pointer, else on the uppermost that has it
  double pixels = 0;
};

/// The vertex nearest to the pixel within `radius` pixels; where several lie on each other that of
/// the uppermost paper. Vertices covered by other paper are not found. The pixel may lie beside the
/// paper.
std::optional<VertexPick> pickVertex(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                     double radius);

struct EdgePick {
  EdgeId edge;
  Spot spot;  ///< nearest point of what is seen of the edge, on a facet that has it and is seen
              ///< there: the one under the pointer, else the uppermost
  double pixels = 0;
};

/// The edge nearest to the pixel, of those that are seen. The pixel may lie beside the paper.
std::optional<EdgePick> pickEdge(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                 double radius);

/// The facets that a rectangle of pixels with corners `a` and `b` holds whole, hidden ones too, by
/// number; for rubber bands.
std::vector<FacetId> facetsWithin(const FoldedState& state, const PaneMap& map, Vec2 a, Vec2 b);

}  // namespace kiri
