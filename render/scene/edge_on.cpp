// Paper that is seen edge-on: a line.
// SPDX-License-Identifier: MIT
#include "render/scene/edge_on.h"

#include <algorithm>

#include "render/visibility/facet_view.h"
#include "render/visibility/grid.h"

namespace kiri {
namespace {

/// Calls visit(facet, use) for every side of every facet seen edge-on.
template <class Visit>
void forEdgeOn(const FoldedState& state, const ViewFrame& view, const Visit& visit) {
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    if (!isEdgeOn(state.poses[f], view, state.tolerance())) continue;
    for (const EdgeUse use : state.pattern.facets[f].border) visit(FacetId(f), use);
  }
}

/// Whether what is seen at a point of the view hides a point of the model that appears there.
class Cover {
 public:
  Cover(const FoldedState& state, const VisibleRegions& regions, const ViewFrame& view)
      : state_(state), regions_(regions), view_(view) {
    for (const VisibleFacet& facet : regions.facets) {
      boxes_.push_back(boundsOf(VisibleRegions{{facet}}));
      Region& region = areas_.emplace_back();
      for (const auto& loop : facet.loops) {
        Loop& arcs = region.loops.emplace_back();
        for (const BoundaryPiece& piece : loop) arcs.push_back(piece.arc);
      }
    }
  }

  /// Parameters at which an arc may come into sight or go out of it.
  std::vector<double> breaks(const Arc& arc) const {
    const Tolerance& tolerance = state_.tolerance();
    const Box box = boundsOf(arc);
    std::vector<double> out{0, 1};
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      if (!boxesMeet(boxes_[i], box, -tolerance.match())) continue;
      for (const Loop& loop : areas_[i].loops) {
        for (const Arc& side : loop) {
          if (!boxesMeet(boundsOf(side), box, -tolerance.match())) continue;
          for (const Meeting& meeting : meetings(arc, side, tolerance)) out.push_back(meeting.t);
        }
      }
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  bool hides(Vec2 p, Vec3 inModel) const {
    const double slack = state_.tolerance().pick();
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      if (!boxesMeet(boxes_[i], {p, p}, 0)) continue;
      if (locate(areas_[i], p, state_.tolerance().match()) != Where::Inside) continue;
      const Rigid& pose = state_.poseOf(regions_.facets[i].facet);
      const Vec3 there = view_.onPlane(p, pose.origin, pose.normal());
      return view_.depth(there) > view_.depth(inModel) - slack;
    }
    return false;
  }

 private:
  const FoldedState& state_;
  const VisibleRegions& regions_;
  const ViewFrame& view_;
  std::vector<Region> areas_;
  std::vector<Box> boxes_;
};

}  // namespace

std::vector<SeenArc> edgeOnBorders(const FoldedState& state, const ViewFrame& view) {
  std::vector<SeenArc> out;
  forEdgeOn(state, view, [&](FacetId facet, EdgeUse use) {
    appendSeen(arcOf(state.pattern, use), state.poseOf(facet), view, state.tolerance().match(),
               out);
  });
  return out;
}

std::vector<Arc> edgeOnLines(const FoldedState& state, const VisibleRegions& regions,
                             const ViewFrame& view) {
  std::vector<Arc> out;
  const Cover cover(state, regions, view);
  std::vector<SeenArc> seen;
  forEdgeOn(state, view, [&](FacetId facet, EdgeUse use) {
    const Arc paper = arcOf(state.pattern, use);
    seen.clear();
    appendSeen(paper, state.poseOf(facet), view, state.tolerance().match(), seen);
    for (const SeenArc& piece : seen) {
      if (lengthOf(piece.arc, state.tolerance().match()) <= state.tolerance().pick()) continue;
      const std::vector<double> breaks = cover.breaks(piece.arc);
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        if (breaks[i + 1] - breaks[i] <= kParallel) continue;
        const double middle = (breaks[i] + breaks[i + 1]) / 2;
        const Vec3 inModel = state.poseOf(facet).apply(pointAt(paper, piece.onPaper(middle)));
        if (cover.hides(pointAt(piece.arc, middle), inModel)) continue;
        out.push_back(part(piece.arc, breaks[i], breaks[i + 1]));
      }
    }
  });
  return out;
}

}  // namespace kiri
