// Where the vertices of a pattern lie when it is folded flat, split where cut paper lies apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/flatfold/flat_map.h"
#include "io/patterns/facet_loops.h"

namespace kiri {

/// Vertices, edges and faces of a folded form. Where nothing is split they are those of the loops,
/// and only `points` differ from the pattern.
struct FoldedVertices {
  bool isSplit = false;
  std::vector<Vec2> points;  ///< folded
  std::vector<Vec2> paper;   ///< the same vertices on the paper
  std::vector<FoldEdge> edges;
  std::vector<std::vector<std::uint32_t>> faces;
};

FoldedVertices foldedVerticesOf(const AssignedPattern& creases, const FlatMap& map,
                                const FacetLoops& loops);

}  // namespace kiri
