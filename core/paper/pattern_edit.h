// The three edits that every fold, tear and cut is made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/paper/crease_pattern.h"

namespace kiri {

/// An edge to be drawn inside a facet.
struct NewEdge {
  VertexId from;
  VertexId to;
  EdgeKind kind = EdgeKind::Hinge;
  std::optional<CurveControls> curve;  ///< none: straight
};

VertexId addVertex(CreasePattern& pattern, Vec2 paper);

/// Puts a vertex on an edge at parameter t (0 < t < 1 in the edge's own direction). Both facets get
/// it, so hinges go on sharing their ends; the edge keeps the first part, the last edge of the
/// pattern is the second.
VertexId splitEdge(CreasePattern& pattern, EdgeId edge, double t);

/// Divides a facet along new edges that lie inside it. Their ends are vertices of the border, of
/// one another, or free; they meet the border and each other only at their ends. Returns the facets
/// that the old one became; the first keeps its id. Edges that separate nothing (a slit) stay in
/// the border of one facet, forth and back.
std::vector<FacetId> divideFacet(CreasePattern& pattern, FacetId facet,
                                 const std::vector<NewEdge>& edges);

/// The pattern with only the facets for which `keep` is true. Edges towards paper that goes become
/// borders; vertices and edges that nothing uses go too. `origin[i]` is the old id of facet i.
struct Kept {
  CreasePattern pattern;
  std::vector<FacetId> origin;
};
Kept keepFacets(const CreasePattern& pattern, const std::vector<bool>& keep);

}  // namespace kiri
