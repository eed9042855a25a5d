// A crease pattern with assignments as shapes: paper, creases, facets.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/creases/assigned_pattern.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"

namespace kiri {

/// Groups print (paper), flat (flat and joins), unassigned, valley, mountain, cut (borders, cuts),
/// in the line styles of `appearance`; `width` mm wide. Empty groups are left out. Every edge is
/// drawn once.
std::vector<Group> assignedGroups(const AssignedPattern& creases, const Affine& toScene,
                                  const Appearance& appearance, double width);

/// The loops of a facet on the page.
std::vector<Loop> facetLoops(const CreasePattern& pattern, FacetId facet, const Affine& toScene);

/// Unassigned creases, in all styles.
inline constexpr Color kUnassignedColor{200, 0, 200};

}  // namespace kiri
