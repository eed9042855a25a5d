// Facets whose planes hold the axis meet like the pages of a book: all at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/sweep/facet_body.h"
#include "core/sweep/found.h"

namespace kiri {

/// Adds what moving pages meet of resting pages strictly inside the motion. Pairs that share a
/// hinge are left out: their fold angle says all (guide to algorithms 1.6). When all pages lie in
/// few planes and none is passed, the cost is that of sorting them.
void meetPages(const FoldedState& state, const std::vector<Body>& moving,
               const std::vector<Body>& resting, const AxisFrame& frame, FirstFound& found);

}  // namespace kiri
