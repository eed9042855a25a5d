// The facets of a pattern as single loops of vertices, as FOLD wants its faces.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/creases/assigned_pattern.h"

namespace kiri {

/// An edge of a FOLD frame and the faces beside it.
struct FoldEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  FacetId left;
  FacetId right;
  EdgeId source;         ///< none for a join that was added
  bool isSplit = false;  ///< one of the two sides of a cut
};

/// Face f is facet f of the pattern. Edges are those of the pattern in their order, then the joins
/// that were added to reach holes.
struct FacetLoops {
  std::vector<std::vector<std::uint32_t>> faces;  ///< counter-clockwise on the paper
  std::vector<FoldEdge> edges;
  std::vector<Assignment> assignments;  ///< of `edges`
  std::size_t joins = 0;                ///< how many edges were added
};

/// For every face the edges of its border: entry i joins vertices i and i + 1.
std::vector<std::vector<std::uint32_t>> faceEdges(
    const std::vector<std::vector<std::uint32_t>>& faces, const std::vector<FoldEdge>& edges);

/// Cost: that of the pattern, but for holes the square of the facet's border.
FacetLoops facetLoopsOf(const AssignedPattern& creases);

}  // namespace kiri
