// Directions of angle steps, and the grid.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/geometry/rigid.h"
#include "editor/snap/catches.h"

namespace kiri {
namespace {

/// Handicaps, as parts of the radius.
constexpr double kOfDirection = 0.6;
constexpr double kOfGrid = 0.7;

/// The direction of the edge of a facet that the point lies on.
std::optional<Vec2> edgeDirection(const FoldedState& state, FacetId facet, Vec2 point) {
  double nearest = state.tolerance().pick();
  std::optional<Vec2> direction;
  for (const EdgeUse use : state.pattern[facet].border) {
    const Arc arc = arcOf(state.pattern, use.edge);
    if (!areNear(boundsOf(arc), {point, point}, nearest)) continue;
    const Nearest on = nearestOn(arc, point);
    const Vec2 tangent = tangentAt(arc, on.t);
    if (on.distance >= nearest || !(length(tangent) > 0)) continue;
    nearest = on.distance;
    direction = normalized(tangent);
  }
  return direction;
}

/// What angle steps count from.
Vec2 zeroDirection(const Neighbourhood& near, FacetId frame, Vec2 from) {
  const FoldedState& state = near.state();
  if (const auto direction = edgeDirection(state, frame, from)) return *direction;
  const bool isSheet = near.map().pane == Pane::Sheet;
  const Rigid pose = near.map().poseOf(state, frame);
  for (std::uint32_t i = 0; i < state.pattern.facets.size(); ++i) {
    const FacetId other(i);
    if (other == frame || !(isSheet || state.layers.areCoplanar(other, frame))) continue;
    const Rigid there = near.map().poseOf(state, other);
    const auto direction = edgeDirection(state, other, there.pullBack(pose.apply(from)));
    if (!direction) continue;
    const Vec3 inSpace = there.direction(*direction);
    return normalized(Vec2{dot(inSpace, pose.x), dot(inSpace, pose.y)});
  }
  return {1, 0};
}

}  // namespace

std::optional<StepDirection> stepDirection(const Neighbourhood& near, const Spot& free, Vec2 from,
                                           double step) {
  const Vec2 to = free.paper - from;
  if (!(step > 0) || !(length(to) > near.state().tolerance().pick())) return std::nullopt;
  const Vec2 zero = zeroDirection(near, free.facet, from);
  const double degrees = std::round(angleDegrees(dot(to, zero), cross(zero, to)) / step) * step;
  const CosSin t = cosSinDegrees(degrees);
  return StepDirection{from, zero * t.cos + perpendicular(zero) * t.sin, degrees};
}

std::vector<Catch> catchesInPlane(const Neighbourhood& near, const SnapQuestion& question) {
  const SnapSettings& settings = question.settings;
  std::vector<Catch> out;
  const auto add = [&](Catch found, double handicap) {
    found.at = near.map().toPixels(near.state(), found.spot);
    found.pixels = distance(found.at, question.pixels);
    found.handicap = handicap * settings.radius;
    if (found.pixels <= settings.radius) out.push_back(found);
  };
  const Spot& free = question.free;
  if (const auto& line = question.direction; line && question.catchesDirection) {
    Catch found;
    found.kind = SnapKind::Angle;
    found.degrees = line->degrees;
    found.spot = {free.facet, line->from + line->along * dot(free.paper - line->from, line->along)};
    add(found, kOfDirection);
  }
  if (settings.gridSpacing > 0) {
    const double mm = settings.gridSpacing;
    Catch found;
    found.kind = SnapKind::Grid;
    found.spot = {free.facet,
                  {std::round(free.paper.x / mm) * mm, std::round(free.paper.y / mm) * mm}};
    add(found, kOfGrid);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Catch& a, const Catch& b) { return a.score() < b.score(); });
  return out;
}

}  // namespace kiri
