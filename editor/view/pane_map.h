// From paper to pixels and back, for either pane.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/model/locate.h"
#include "core/paper/folded_state.h"
#include "editor/base/events.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// How a pane shows the paper at this moment. The sheet pane shows every facet as it lies in the
/// paper frame (z = 0, seen from the front or the back); the model pane as its pose says.
struct PaneMap {
  Pane pane = Pane::Model;
  ViewFrame frame;
  double pixelsPerMm = 1;  ///< of view coordinates
  Vec2 centre;             ///< view coordinates of the middle of the pane, mm
  Vec2 size{1, 1};         ///< pixels

  /// Pixels (y down) of a point of this pane's space: model frame, or paper frame with z = 0.
  Vec2 toPixels(Vec3 point) const;
  Vec2 toPixels(const FoldedState& state, const Spot& spot) const;
  /// View coordinates, mm, of a pixel.
  Vec2 toView(Vec2 pixels) const;
  /// Where a facet's paper lies in this pane's space.
  Vec3 placeOf(const FoldedState& state, const Spot& spot) const;
  /// The pose with which a facet appears in this pane.
  Rigid poseOf(const FoldedState& state, FacetId facet) const;
  /// Where the line of sight through a pixel meets the plane of a facet, in the paper frame of the
  /// facet (which may lie beyond its paper); none when the plane is seen edge-on or lies behind.
  std::optional<Vec2> onPlaneOf(const FoldedState& state, FacetId facet, Vec2 pixels) const;
  /// True when the facet turns its front to the eye here.
  bool showsFront(const FoldedState& state, const Spot& spot) const;
};

}  // namespace kiri
