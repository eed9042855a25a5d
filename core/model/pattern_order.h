// Which layer order a folded pattern gets, and what is wrong with one that was given.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// Finds a layer order of a state folded flat, with as many of the `wanted` orders (places on the
/// paper) as can be had together: all, or else none. Errors: those of overlapsOf and
/// LayerStates::find; BadValue - no order exists, with facets that cannot be ordered. The value
/// says whether the wanted orders hold.
Result<bool> searchLayers(FoldedState& folded, const std::vector<Assignment>& assignments,
                          const std::vector<DrawnOrder>& wanted, const Progress& progress = {});

/// Orders the facets of a state that is not flat by where they come from when the angles are all
/// folded in proportion.
void orderPartly(FoldedState& folded);

/// Orders the facets as `orders` say, places on the paper; facets that nothing is said of stay in
/// the order that they have in their planes. Orders of places without paper, or of facets in
/// different planes, are left out.
void orderAs(FoldedState& folded, const std::vector<DrawnOrder>& orders);

/// Directions of the unassigned hinges that are folded flat, as the layers say.
void directUnassigned(FoldedState& folded, const std::vector<Assignment>& assignments);

/// What is wrong with where the paper lies: paper through paper. None when nothing is.
std::optional<Collision> faultOf(const FoldedState& folded);

}  // namespace kiri
