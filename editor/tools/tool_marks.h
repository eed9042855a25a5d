// Marks that several tools draw: what is selected. What is wrong is drawn by the session.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"
#include "editor/view/marks.h"
#include "editor/view/selection.h"

namespace kiri {

/// Selected things as marks: outlines of facets, points, lines.
void addSelected(const FoldedState& state, const std::vector<Selected>& items, MarkRole role,
                 Marks& marks);

/// The outline of a facet, its holes left out.
PathMark outlineOf(const FoldedState& state, FacetId facet, MarkRole role);

}  // namespace kiri
