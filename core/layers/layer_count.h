// How many layers of paper lie on each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/paper/folded_state.h"

namespace kiri {

/// The largest number of facets that lie on each other at any place of any plane; places narrower
/// than the tolerance of contact do not count. Curves are taken as polylines. An upright line
/// sweeps over the plane from corner to corner and crossing to crossing of the facets' sides; cost:
/// places where it stops times sides that it meets there.
std::uint32_t maxLayerCount(const FoldedState& state);

}  // namespace kiri
