// A facet as loops of points in space, and how deep two of them stand in each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// Written apart from the kernel: loops of points, cut by the plane of another facet. Borders are
/// those of the paper: creases that lie flat between facets that move alike are none.
struct SpacePiece {
  FacetId facet;
  Vec3 normal;
  std::vector<std::vector<Vec3>> loops;
  std::vector<std::vector<bool>> isBorder;  ///< of the side that starts at the point
  std::vector<Vec3> inner;                  ///< points inside
};

/// `moves`: which facets move alike; empty when all do.
SpacePiece spacePieceOf(const FoldedState& state, FacetId facet, const std::vector<bool>& moves);

/// Whether a point of the plane of the piece lies inside its loops.
bool holds(const SpacePiece& piece, Vec3 p);
/// mm to the nearest border.
double borderDistance(const SpacePiece& piece, Vec3 p);
/// How deep they stand in each other: mm from the best place where both have paper to the nearest
/// border of either; 0 when they do not, or lie in parallel planes.
double depthOf(const SpacePiece& a, const SpacePiece& b);

}  // namespace kiri::test
