// The stacks of facets over the cells of the ground, and the pairs in them.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/flatfold/cell_facets.h"
#include "core/flatfold/order_problem.h"

namespace kiri {

/// The sets of facets over cells, without those of fewer than two facets and those that are part of
/// another; in the order of the cells.
FacetSets stacksOf(const PlanarCells& cells, const CellFacets& facets);

/// All pairs of facets that are in one stack together, sorted.
std::vector<FacetPair> pairsOf(const FacetSets& stacks, std::size_t facetCount);

}  // namespace kiri
