// What is seen of each plane of the model from its two sides, whatever the direction of view.
// SPDX-License-Identifier: MIT
#include "render/visibility/plane_regions.h"

#include <algorithm>

#include "core/base/check.h"
#include "render/visibility/facet_view.h"
#include "render/visibility/regions_of_views.h"

namespace kiri {

PlaneRegions planeRegionsOf(const FoldedState& state, std::uint32_t set) {
  const LayerSet& layers = state.layers.sets()[set];
  KIRI_CHECK(!layers.upward.empty(), "a plane holds facets");
  // The axes of one of its facets, so that flat models keep the coordinates of the paper.
  const Rigid& pose = state.poseOf(layers.upward.front());
  const double up = dot(pose.z, layers.normal) > 0 ? 1 : -1;
  PlaneRegions out;
  out.set = set;
  out.point = pose.origin;
  out.above = {pose.x, pose.y * up, pose.z * up};
  out.below = {-out.above.right, out.above.up, -out.above.toEye};
  out.fromAbove = regionsOfViews(FacetViews(state, out.above, set));
  out.fromBelow = regionsOfViews(FacetViews(state, out.below, set));
  return out;
}

std::vector<PlaneRegions> planeRegions(const FoldedState& state) {
  std::vector<PlaneRegions> out;
  for (std::uint32_t set = 0; set < state.layers.sets().size(); ++set) {
    if (!state.layers.sets()[set].upward.empty()) out.push_back(planeRegionsOf(state, set));
  }
  return out;
}

Region onPaper(const FoldedState& state, const VisibleFacet& part, const ViewFrame& view) {
  KIRI_CHECK(!view.isPerspective(), "in perspective a cubic of the view is none on the paper");
  const Rigid& pose = state.poseOf(part.facet);
  const auto back = [&](Vec2 p) {
    return pose.pullBack(view.onPlane(p, pose.origin, pose.normal()));
  };
  Region out;
  for (const auto& loop : part.loops) {
    Loop& arcs = out.loops.emplace_back();
    for (const BoundaryPiece& piece : loop) {
      const Arc& arc = piece.arc;
      arcs.push_back(arc.isCurved ? Arc::cubic(back(arc.start), back(arc.control1),
                                               back(arc.control2), back(arc.end))
                                  : Arc::line(back(arc.start), back(arc.end)));
    }
    if (part.showsFront) continue;
    std::reverse(arcs.begin(), arcs.end());
    std::transform(arcs.begin(), arcs.end(), arcs.begin(), reversed);
  }
  return out;
}

}  // namespace kiri
