// What is seen of each plane of the model from its two sides, whatever the direction of view.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/region.h"
#include "core/paper/folded_state.h"
#include "render/visibility/view_frame.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

/// The facets of one layer-set, each less what lies over it in the same plane.
struct PlaneRegions {
  std::uint32_t set = 0;     ///< number of the layer-set
  ViewFrame above;           ///< looks straight down on the plane, against the normal of the set
  ViewFrame below;           ///< looks straight up at it
  VisibleRegions fromAbove;  ///< in the coordinates of `above`
  VisibleRegions fromBelow;  ///< in the coordinates of `below`
  Vec3 point;                ///< of the plane, model frame

  /// True when a view sees the plane from above.
  bool isSeenFromAbove(const ViewFrame& view) const { return view.facing(above.toEye, point) > 0; }
  const VisibleRegions& seenFrom(const ViewFrame& view) const {
    return isSeenFromAbove(view) ? fromAbove : fromBelow;
  }
};

/// One entry for each layer-set that holds facets, by number. Valid for every view, in perspective
/// too, until the state changes: going round the model only picks a side of each plane, and a depth
/// buffer does the rest, for within a plane no two parts overlap (guide/algorithms.md 3.2, 3.3).
std::vector<PlaneRegions> planeRegions(const FoldedState& state);

/// The same for one layer-set, for motions in which the others keep their order.
PlaneRegions planeRegionsOf(const FoldedState& state, std::uint32_t set);

/// A part seen in an orthographic view on the paper of its facet, paper frame, so that it moves
/// with the facet's pose and carries its texture. Loops run with the part on their left as seen
/// from the front.
Region onPaper(const FoldedState& state, const VisibleFacet& part, const ViewFrame& view);

}  // namespace kiri
