// Tears and cuts that end inside a facet.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"
#include "render/visibility/view_frame.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

/// A piece of a slit.
struct SlitPiece {
  Arc arc;  ///< view coordinates
  EdgeId edge;
};

/// What is seen of the slits of a facet. They take nothing away from what is seen of the facet, so
/// they are no part of its border.
std::vector<SlitPiece> visibleSlits(const FoldedState& state, const VisibleFacet& facet,
                                    const ViewFrame& view);

}  // namespace kiri
