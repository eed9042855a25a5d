// The ground that flat folded paper covers, divided along all its folded edges.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/flatfold/order_problem.h"

namespace kiri {

/// A piece of ground over which the same facets lie everywhere.
struct GroundCell {
  std::vector<std::uint32_t> corners;  ///< into FoldedGround::points, counter-clockwise
  std::vector<FacetId> facets;         ///< sorted
};

/// The arrangement of the folded edges. Folded points that ought to coincide do: `within` is the
/// distance that was found to give a consistent map.
struct FoldedGround {
  std::vector<Vec2> points;  ///< folded plane, mm
  std::vector<GroundCell> cells;
  double within = 0;
};

/// The ground and the constraints between facets that lie on it. Cells are found from a map of
/// points clustered within a distance that is tried from fine to coarse until every edge changes
/// the facets beside it by exactly its own (guide to algorithms 4.3, 10.1). Errors: BadValue - no
/// distance gives a consistent map, with the place; Cancelled.
struct GroundAndOrders {
  FoldedGround ground;
  OrderProblem problem;
};
Result<GroundAndOrders> overlapsOf(const AssignedPattern& creases, const FlatMap& map,
                                   const Progress& progress = {});

}  // namespace kiri
