// Folded states of a crease pattern as a FOLD file: the pattern, and a folded form for each state.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/flatfold/flat_folding.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

struct StatesFoldOptions {
  std::string creator = "KiriSim";
  std::string title;
  std::string description;
  /// What a unit of length is (FOLD, frame_unit): "mm", or "unit" where the file had no size.
  std::string unit = "mm";
  /// Up to so many face orders are written in all; above that, pairs that follow from others of one
  /// place are left out.
  std::size_t mostOrders = 2'000'000;
};

/// One state, for a frame of its own.
struct StateFrame {
  std::string title;
  LayerValues values;
};

/// A FOLD 1.2 file. The key frame is the crease pattern with its own coordinates, assignments and
/// facets; each state is a folded form that inherits from it and adds folded coordinates (2D, the
/// facet of the largest area where it lies on the paper), the directions that unassigned creases
/// have there, and the order of every two facets that overlap. Where paper is cut and its two sides
/// lie apart, the folded form has vertices and edges of its own. Holes of facets are joined to
/// their outline by join edges. `losses` names what was left out.
WrittenPattern writeStates(const AssignedPattern& creases, const FlatMap& map,
                           const OrderProblem& problem, const std::vector<StateFrame>& states,
                           const StatesFoldOptions& options = {});

/// The direction that a hinge has in a state: Mountain or Valley where it is folded, else what the
/// pattern says. Requires values of `problem`, made from these creases.
Assignment foldedAs(const AssignedPattern& creases, const FlatMap& map, const OrderProblem& problem,
                    const LayerValues& values, EdgeId edge);

}  // namespace kiri
