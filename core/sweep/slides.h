// Paper that slides within its own plane, and what has an edge in that plane.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/sweep/facet_body.h"
#include "core/sweep/found.h"

namespace kiri {

/// Adds what facets that turn within their plane (or rest in such a plane) meet of edges in it.
/// Where paper runs through the plane at a hinge they collide. Where a hinge bends out of the plane
/// the layer order says whether they do. Paper that comes to lie over other paper of the plane,
/// sliding, may go over or under it: that is undecided.
void meetSlides(const FoldedState& state, const std::vector<bool>& moves,
                const std::vector<Body>& moving, const std::vector<Body>& resting,
                const AxisFrame& frame, FirstFound& found);

}  // namespace kiri
