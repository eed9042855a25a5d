// Layer order after facets were divided or dropped.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/layer_order.h"

namespace kiri {

/// The order of new facets, each of which takes the place of the old facet it came from:
/// `origin[i]` is the old id of facet i. Facets without successors leave the order, and with them
/// sets that become empty.
LayerOrder refined(const LayerOrder& order, const std::vector<FacetId>& origin);

}  // namespace kiri
