// The lines in which the picture changes from one facet to another, or to nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "render/visibility/arrangement.h"
#include "render/visibility/coverage.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

/// A seam as one of the facets that it parts sees it: that facet is on the left.
struct HalfSeam {
  static constexpr std::uint32_t kNoFacet = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t from = 0;  ///< vertex of the map
  std::uint32_t to = 0;
  std::uint32_t facet =
      kNoFacet;         ///< place in FacetViews::all(); kNoFacet: the outside of a silhouette
  BoundaryPiece piece;  ///< empty when there is no facet
};

/// Seams in pairs: halves 2k and 2k + 1 are the two views of one. Sides of the map that continue
/// each other along one edge are one seam.
std::vector<HalfSeam> seamsOf(const FacetViews& views, const Arrangement& map,
                              const std::vector<SeenBeside>& seen);

}  // namespace kiri
