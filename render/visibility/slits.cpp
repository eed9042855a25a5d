// Tears and cuts that end inside a facet.
// SPDX-License-Identifier: MIT
#include "render/visibility/slits.h"

#include <algorithm>

#include "core/geometry/region.h"
#include "render/visibility/projection.h"

namespace kiri {
namespace {

/// Adds the parts of an arc that lie inside what is seen of a facet.
void appendInside(const VisibleFacet& facet, const Arc& arc, EdgeId edge,
                  const Tolerance& tolerance, std::vector<SlitPiece>& out) {
  Region region;
  std::vector<double> breaks{0, 1};
  for (const auto& loop : facet.loops) {
    Loop& arcs = region.loops.emplace_back();
    for (const BoundaryPiece& piece : loop) {
      arcs.push_back(piece.arc);
      for (const Meeting& meeting : meetings(arc, piece.arc, tolerance)) {
        breaks.push_back(meeting.t);
      }
    }
  }
  std::sort(breaks.begin(), breaks.end());
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i + 1] - breaks[i] <= kParallel) continue;
    const Vec2 middle = pointAt(arc, (breaks[i] + breaks[i + 1]) / 2);
    if (locate(region, middle, tolerance.length()) != Where::Inside) continue;
    out.push_back({part(arc, breaks[i], breaks[i + 1]), edge});
  }
}

}  // namespace

std::vector<SlitPiece> visibleSlits(const FoldedState& state, const VisibleFacet& facet,
                                    const ViewFrame& view) {
  std::vector<SlitPiece> out;
  for (const EdgeUse use : state.pattern[facet.facet].border) {
    const Edge& edge = state.pattern[use.edge];
    if (use.isReversed || edge.left != edge.right || edge.kind == EdgeKind::Hinge) continue;
    std::vector<SeenArc> seen;
    appendSeen(arcOf(state.pattern, use), state.poseOf(facet.facet), view,
               state.tolerance().match(), seen);
    for (const SeenArc& piece : seen) {
      appendInside(facet, piece.arc, use.edge, state.tolerance(), out);
    }
  }
  return out;
}

}  // namespace kiri
