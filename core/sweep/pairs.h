// Facets in general position: which pairs can meet at all, and when they first do.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/sweep/facet_body.h"
#include "core/sweep/found.h"

namespace kiri {

/// Adds what moving facets meet of resting ones strictly inside the motion, but for two pages (see
/// meetPages) and two facets that both turn within one plane.
void meetPairs(const FoldedState& state, const std::vector<bool>& moves,
               const std::vector<Body>& moving, const std::vector<Body>& resting,
               const AxisFrame& frame, FirstFound& found);

}  // namespace kiri
