// Leaves out the facets that nothing is seen of.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "render/visibility/facet_view.h"

namespace kiri {

/// Numbers (places in views.all(), ascending) of the facets that may be seen. Left out are only
/// facets that those over them cover, up to places thinner than the flattening of curves. Goes from
/// the top down and takes only what it has kept as occluders: the union of what is seen is the
/// union of all. Source: guide/stack.md section 4.
std::vector<std::uint32_t> facetsInSight(const FacetViews& views);

}  // namespace kiri
