// A facet that shares no edge with others.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/paper/crease_pattern.h"

namespace kiri {

/// Adds a facet with vertices and straight border edges of its own. `corners`: a convex polygon,
/// counter-clockwise, paper frame; it may lie over other facets, as the paper of no real sheet
/// does: for pictures and measurements.
FacetId addLooseFacet(CreasePattern& pattern, std::span<const Vec2> corners);

}  // namespace kiri
