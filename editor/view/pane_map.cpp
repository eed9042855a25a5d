// From paper to pixels and back.
// SPDX-License-Identifier: MIT
#include "editor/view/pane_map.h"

#include <cmath>

#include "core/geometry/tolerance.h"
#include "render/visibility/facet_view.h"

namespace kiri {

Vec2 PaneMap::toPixels(Vec3 point) const {
  const Vec2 away = frame.project(point) - centre;
  return {size.x / 2 + away.x * pixelsPerMm, size.y / 2 - away.y * pixelsPerMm};
}

Vec2 PaneMap::toPixels(const FoldedState& state, const Spot& spot) const {
  return toPixels(placeOf(state, spot));
}

Vec2 PaneMap::toView(Vec2 pixels) const {
  return {centre.x + (pixels.x - size.x / 2) / pixelsPerMm,
          centre.y - (pixels.y - size.y / 2) / pixelsPerMm};
}

Vec3 PaneMap::placeOf(const FoldedState& state, const Spot& spot) const {
  if (pane == Pane::Sheet) return {spot.paper.x, spot.paper.y, 0};
  return state.poseOf(spot.facet).apply(spot.paper);
}

Rigid PaneMap::poseOf(const FoldedState& state, FacetId facet) const {
  return pane == Pane::Sheet ? Rigid{} : state.poseOf(facet);
}

std::optional<Vec2> PaneMap::onPlaneOf(const FoldedState& state, FacetId facet, Vec2 pixels) const {
  const Rigid pose = poseOf(state, facet);
  if (isEdgeOn(pose, frame, state.tolerance())) return std::nullopt;
  const Vec2 at = toView(pixels);
  if (frame.isPerspective()) {  // the line of sight may run beside the plane, or meet it behind
    const Vec2 aside = at - frame.direction(frame.centre);
    const Vec3 ray = frame.right * aside.x + frame.up * aside.y - frame.toEye * frame.eyeDistance;
    const double along = dot(ray, pose.normal());
    if (std::abs(along) <= kSamePlane * length(ray)) return std::nullopt;
    if (dot(pose.origin - frame.eye(), pose.normal()) / along <= 0) return std::nullopt;
  }
  return pose.pullBack(frame.onPlane(at, pose.origin, pose.normal()));
}

bool PaneMap::showsFront(const FoldedState& state, const Spot& spot) const {
  return frame.facing(poseOf(state, spot.facet).normal(), placeOf(state, spot)) > 0;
}

}  // namespace kiri
