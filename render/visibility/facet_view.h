// One facet as it lies in the view.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/cubic.h"
#include "core/geometry/region.h"
#include "core/paper/folded_state.h"
#include "render/visibility/projection.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// True when a facet is seen edge-on: narrower than any line, and its depth would be all rounding.
bool isEdgeOn(const Rigid& pose, const ViewFrame& view, const Tolerance& tolerance);

/// A facet in view coordinates. Arcs run with the paper on their left, whichever side of it is
/// seen.
struct FacetView {
  FacetId id;
  bool showsFront = true;
  bool isConvex = false;   ///< one convex loop of straight arcs
  bool isFlipped = false;  ///< the normal of its layer-set points away from the eye
  std::uint32_t set = 0;   ///< its layer-set
  std::uint32_t rank = 0;  ///< place in its set as seen from the eye, 0 at the bottom
  std::vector<Arc> arcs;
  std::vector<EdgeUse> uses;              ///< where each arc comes from
  std::vector<SeenArc> sources;           ///< in perspective: which part of it each arc shows
  std::vector<std::uint32_t> loopStarts;  ///< first arc of each loop
  Box box;
  double depth0 = 0;  ///< depth at (x, y) is depth0 + dot(slope, (x, y))
  Vec2 slope;

  double depthUnit = 1;  ///< at most so many mm of depth are a mm of the model

  double depthAt(Vec2 p) const { return depth0 + dot(slope, p); }
  /// The parameter on its edge, in the edge's own direction, of a point of an arc.
  double onEdge(std::uint32_t arc, double t) const;
  Region region() const;
};

/// The facets of a state in one view, and which of them lies over which. Keeps a reference to the
/// state. In perspective the eye must lie outside of the model.
class FacetViews {
 public:
  FacetViews(const FoldedState& state, const ViewFrame& view);
  /// The facets of one layer-set only.
  FacetViews(const FoldedState& state, const ViewFrame& view, std::uint32_t onlySet);

  /// All facets that are not seen edge-on, by layer-set, nearest set first, and in it from the top
  /// down.
  const std::vector<FacetView>& all() const { return views_; }
  const Tolerance& tolerance() const { return state_.tolerance(); }

  /// True when `a` hides `b` at `p` and a little towards `side` of it, both being there.
  bool isOver(const FacetView& a, const FacetView& b, Vec2 p, Vec2 side) const;
  /// True when all lie in one plane and the list says all: those that come first in all() are over
  /// those after them.
  bool isPlainStack() const;
  const ViewFrame& frame() const { return frame_; }
  /// How far the depths of two planes may differ where they touch.
  double depthTolerance(const FacetView& a, const FacetView& b) const;
  /// The facets that lie over facet `number` against the order of the list of their set; numbers
  /// are places in all().
  std::vector<std::uint32_t> exceptionsOver(std::uint32_t number) const;

 private:
  struct SetInView {
    std::uint32_t number = 0;
    bool isFlipped = false;  ///< its normal points away from the eye
  };

  void addSet(std::uint32_t set);
  void add(FacetId facet, std::uint32_t rank);
  void addBorder(FacetId facet, FacetView& out) const;
  void collectExceptions();
  bool isOverInSet(const FacetView& a, const FacetView& b) const;

  const FoldedState& state_;
  ViewFrame frame_;
  std::vector<FacetView> views_;
  std::vector<SetInView> sets_;  ///< nearest first
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      exceptions_;  ///< (lower, upper) as seen, sorted
};

}  // namespace kiri
