// Which facet is seen on either side of every side of the planar map.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "render/visibility/arrangement.h"
#include "render/visibility/facet_view.h"

namespace kiri {

/// The facets seen left and right of a side, as places in FacetViews::all(); kNothing where there
/// is no paper.
struct SeenBeside {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t left = kNothing;
  std::uint32_t right = kNothing;
};

/// One entry for each side of the map. A facet whose border runs along the side is there on that
/// hand; any other is there on both hands when it holds the middle of the side. Of those that are
/// there the one over all others is seen.
std::vector<SeenBeside> seenBesideSides(const FacetViews& views,
                                        const std::vector<std::uint32_t>& inSight,
                                        const Arrangement& map);

}  // namespace kiri
