// What ties the orders of overlapping facets together, read off the pieces of the ground's lines.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/flatfold/cell_facets.h"
#include "core/flatfold/order_problem.h"

namespace kiri {

/// Everything that is known of the lines of a ground.
struct GroundLines {
  const Arrangement& arrangement;
  const PlanarCells& cells;
  const CellFacets& facets;
  const FoldedLines& lines;
  const LinesAlong& along;
};

/// Fills `same` and `interleavings` of a problem whose pairs are indexed. Which side of a fold
/// other paper lies on is decided beside each piece, so facets need not be convex. False when
/// cancelled. Source: guide to algorithms 2.2.
bool addRules(const GroundLines& ground, OrderProblem& problem, const Progress& progress);

/// Fills `known`: a valley has the front of its upper facet down, a mountain the back.
void addKnown(const AssignedPattern& creases, const FlatMap& map, OrderProblem& problem);

}  // namespace kiri
