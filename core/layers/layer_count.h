// How many layers of paper lie on each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/paper/folded_state.h"

namespace kiri {

/// The largest number of facets that lie on each other at any place of any plane; places narrower
/// than the tolerance of contact do not count. Curves are taken as polylines. Keeps convex cells
/// that do not overlap, each with its depth, and lays the facets on them one by one; cost is
/// near-linear in facets and cells.
std::uint32_t maxLayerCount(const FoldedState& state);

}  // namespace kiri
