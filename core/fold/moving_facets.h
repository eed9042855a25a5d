// Which facets a motion takes along (thesis 5.2), and whether the paper allows it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/layers/relayer.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// True when both ends of the edge, as its left or right facet holds it, lie on the axis of the
/// motion.
bool liesOnAxis(const FoldedState& state, const Edge& edge, const Motion& axis);

/// The facets joined to `seeds` by paper: along every hinge that does not lie on the axis. A
/// rotation of exactly these about the axis stretches nothing, for a hinge between moving and
/// resting paper must lie on the axis. Paper that is rolled up goes along: what hangs on moving
/// paper only, by a crease on the axis that is folded right over; without `fixedSeeds` it is not
/// looked for. `broken` is empty unless that takes along a facet of
/// `fixedSeeds`, which is meant to rest: then it is the chain of hinges that leads from a seed to
/// it, one of which would have to give way.
struct MovingSet {
  std::vector<bool> moves;
  std::vector<EdgeId> broken;
};
MovingSet movingFacets(const FoldedState& state, const Motion& axis,
                       const std::vector<FacetId>& seeds, const std::vector<FacetId>& fixedSeeds);

}  // namespace kiri
