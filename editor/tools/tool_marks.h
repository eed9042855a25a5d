// Marks that several tools draw: what is wrong, and where paper meets paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"
#include "editor/view/marks.h"
#include "editor/view/selection.h"

namespace kiri {

/// The hinges and points that an error names, as faults. Those beside the paper are left out.
void addWitness(const FoldedState& state, const Witness& witness, Marks& marks);

/// The places of a few of the collisions.
void addCollisions(const std::vector<Collision>& collisions, Marks& marks);

/// Selected things as marks: outlines of facets, points, lines.
void addSelected(const FoldedState& state, const std::vector<Selected>& items, MarkRole role,
                 Marks& marks);

/// The outline of a facet, its holes left out.
PathMark outlineOf(const FoldedState& state, FacetId facet, MarkRole role);

}  // namespace kiri
