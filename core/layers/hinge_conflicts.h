// Whether paper passes through paper along the hinges of a plane.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// Two runs of paper that pass through each other where a hinge lies: the facets of either run.
/// A run without a hinge there has the same facet twice.
struct HingeConflict {
  FacetId first[2];
  FacetId second[2];
};

/// Which runs are looked at.
struct ConflictScope {
  /// Only pairs of runs with both moving and resting facets; all pairs when empty.
  std::vector<bool> moves = {};
  std::size_t most = 16;  ///< no more conflicts than this are looked for
  EdgeId only = {};       ///< where valid: only pairs with the run of this hinge
};

/// What is wrong along the hinges of one layer-set, where they run through the inside of other
/// facets of it and where they share a line: a fold with paper through it, folds that interleave,
/// flat paper that changes sides of other paper, paper that stands on the plane and pierces a layer
/// or other standing paper, and standing paper of equal angle in another order than in the plane it
/// stands in. Decided beside each hinge, not by facets as a whole. Source: guide to algorithms 2.2
/// and 2.5. Cost: hinges times facets of the set, and hinges squared.
std::vector<HingeConflict> hingeConflicts(const CreasePattern& pattern,
                                          const std::vector<Rigid>& poses, const LayerOrder& order,
                                          std::size_t set, const ConflictScope& scope);

}  // namespace kiri
