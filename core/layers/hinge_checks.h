// Whether a hinge passes through other paper of its plane.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/paper/folded_state.h"

namespace kiri {

/// A facet that is in the way of a hinge. Flat or folded (0, 180 or -180 degrees): it lies between
/// the two facets where the hinge runs, so that the hinge goes through it: inside it, or between it
/// and what it is folded to along the same line. At other angles: the paper that stands on the
/// plane of one facet goes through it. None when the hinge is clear. Source: the taco and tortilla
/// conditions of flat folding.
std::optional<FacetId> facetThrough(const FoldedState& state, const Edge& hinge);

/// A hinge that stands on a plane: one of its facets lies in the plane, the other leaves it.
struct Standing {
  FacetId lying;
  FacetId leaving;
  Vec3 from;
  Vec3 to;
  bool goesUp = false;  ///< along the normal of the layer-set
};

/// The hinges that stand on the plane of a layer-set.
std::vector<Standing> standingOn(const CreasePattern& pattern, const std::vector<Rigid>& poses,
                                 const LayerSet& set);

/// True when the segment, in the model frame and in the plane of the facet, runs through the inside
/// of its paper.
bool runsThrough(const CreasePattern& pattern, const Rigid& pose, FacetId facet, Vec3 from,
                 Vec3 to);

}  // namespace kiri
