// Which layer order a folded pattern gets, and what is wrong with one that was given.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The creases of a state as a pattern: its angles are the targets.
AssignedPattern targetsOf(const FoldedState& folded, const std::vector<Assignment>& assignments);

/// Finds a layer order of a state folded flat, and the direction of each hinge that is unassigned.
/// Errors: those of flatFold; BadValue - no order exists, with facets that cannot be ordered.
Status searchLayers(FoldedState& folded, const std::vector<Assignment>& assignments,
                    const Progress& progress = {});

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
