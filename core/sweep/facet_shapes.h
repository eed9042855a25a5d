// Facets as convex pieces of the sheet, and which of them are joined where.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// Convex polygons of the paper frame.
using Pieces = std::vector<std::vector<Vec2>>;

/// What stands for a facet: its convex pieces, or one convex hull that holds them all.
enum class FacetDetail { Exact, Hull };

/// The facets of a pattern, for comparing them in pairs.
class FacetShapes {
 public:
  explicit FacetShapes(const CreasePattern& pattern, FacetDetail detail = FacetDetail::Exact);

  std::size_t size() const { return pieces_.size(); }
  const Pieces& piecesOf(FacetId facet) const { return pieces_[facet.index]; }
  bool shareHinge(FacetId a, FacetId b) const;
  /// The pieces of both; where paper joins them at a vertex, without what lies near it: a corner of
  /// each piece is cut off, by the same length along its sides, and so little that what is common
  /// to the two corners' angles goes on beyond. The pieces live as long as the shapes.
  const std::pair<Pieces, Pieces>& pairOf(FacetId a, FacetId b) const;

 private:
  void joinAround(VertexId vertex, const std::vector<EdgeId>& hinges);
  std::vector<VertexId> commonVertices(FacetId a, FacetId b) const;

  const CreasePattern& pattern_;
  std::vector<Pieces> pieces_;
  /// For each facet its vertices with hinges, each with the lowest facet that hinges join it to
  /// around the vertex.
  std::vector<std::vector<std::pair<VertexId, FacetId>>> fans_;
  mutable std::map<std::pair<FacetId, FacetId>, std::pair<Pieces, Pieces>> pairs_;
};

}  // namespace kiri
