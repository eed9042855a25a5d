// The steps from facets in a view to what is seen of them.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/visibility/facet_view.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

/// What is seen of the facets in `views` when there is nothing else.
VisibleRegions regionsOfViews(const FacetViews& views);

}  // namespace kiri
