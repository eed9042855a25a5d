// SPDX-License-Identifier: MIT
#include "core/layers/hinge_checks.h"

#include <algorithm>
#include <cmath>

#include "core/paper/inscribe.h"

namespace kiri {
namespace {

struct Segment {
  Vec3 from;
  Vec3 to;
};

Segment segmentOf(const FoldedState& state, const Edge& edge) {
  const Rigid& pose = state.poseOf(edge.left);
  return {pose.apply(state.pattern[edge.from]), pose.apply(state.pattern[edge.to])};
}

/// Direction from the hinge into one of its facets, model frame.
Vec3 inward(const FoldedState& state, const Edge& edge, bool ofLeft) {
  const Vec2 normal = perpendicular(state.pattern[edge.to] - state.pattern[edge.from]);
  return state.poseOf(ofLeft ? edge.left : edge.right).direction(ofLeft ? normal : -normal);
}

bool isBetween(const FoldedState& state, FacetId facet, const Edge& hinge) {
  return state.layers.isAbove(facet, hinge.left) != state.layers.isAbove(facet, hinge.right);
}

/// True when two segments lie in one line and share more than a point.
bool doShareStretch(const Segment& a, const Segment& b, const Tolerance& tolerance) {
  const double span = distance(a.from, a.to);
  const Vec3 along = (a.to - a.from) / span;
  if (length(cross(along, b.from - a.from)) > tolerance.match()) return false;
  if (length(cross(along, b.to - a.from)) > tolerance.match()) return false;
  const double s = dot(along, b.from - a.from);
  const double t = dot(along, b.to - a.from);
  return std::min(span, std::max(s, t)) - std::max(0.0, std::min(s, t)) > tolerance.match();
}

bool isFolded(const Edge& edge) {
  return edge.kind == EdgeKind::Hinge && std::abs(edge.angle) == 180;
}

/// Two folds along one line on one side must nest or lie apart.
std::optional<FacetId> interleavedWith(const FoldedState& state, const Edge& hinge) {
  const Segment segment = segmentOf(state, hinge);
  const Vec3 side = inward(state, hinge, true);
  for (const Edge& other : state.pattern.edges) {
    if (&other == &hinge || !isFolded(other) || !state.layers.areCoplanar(other.left, hinge.left))
      continue;
    if (dot(inward(state, other, true), side) <= 0) continue;
    if (!doShareStretch(segment, segmentOf(state, other), state.tolerance())) continue;
    if (other.left == hinge.left || other.left == hinge.right) continue;
    if (other.right == hinge.left || other.right == hinge.right) continue;
    const bool isLeftIn = isBetween(state, other.left, hinge);
    if (isLeftIn != isBetween(state, other.right, hinge))
      return isLeftIn ? other.left : other.right;
  }
  return std::nullopt;
}

}  // namespace

bool runsThrough(const CreasePattern& pattern, const Rigid& pose, FacetId facet, Vec3 from,
                 Vec3 to) {
  return !chordsOf(pattern, facet, pose.pullBack(from), pose.pullBack(to)).empty();
}

std::vector<Standing> standingOn(const CreasePattern& pattern, const std::vector<Rigid>& poses,
                                 const LayerSet& set) {
  std::vector<Standing> found;
  for (const FacetId lying : set.upward) {
    for (const EdgeUse use : pattern[lying].border) {
      const Edge& edge = pattern[use.edge];
      if (edge.kind != EdgeKind::Hinge) continue;
      const FacetId leaving = across(edge, lying);
      const Rigid& pose = poses[leaving.index];
      const Vec2 along = pattern[endOf(pattern, use)] - pattern[startOf(pattern, use)];
      // The facet across lies on the right of the border as this facet runs along it.
      const double rise = dot(set.normal, pose.direction(-perpendicular(along)));
      if (std::abs(rise) <= kSamePlane * length(along)) continue;  // lies in the plane as well
      const Rigid& own = poses[lying.index];
      found.push_back({lying, leaving, own.apply(pattern[startOf(pattern, use)]),
                       own.apply(pattern[endOf(pattern, use)]), rise > 0});
    }
  }
  return found;
}

namespace {

/// A layer through which the paper of a partly folded hinge stands.
std::optional<FacetId> piercedBy(const FoldedState& state, const Edge& hinge) {
  for (const FacetId side : {hinge.left, hinge.right}) {
    const LayerSet& set = state.layers.sets()[state.layers.setOf(side)];
    for (const Standing& standing : standingOn(state.pattern, state.poses, set)) {
      if (standing.lying != side || standing.leaving != across(hinge, side)) continue;
      for (const FacetId f : set.upward) {
        if (f == side || state.layers.isAbove(side, f) == standing.goesUp) continue;
        if (runsThrough(state.pattern, state.poseOf(f), f, standing.from, standing.to)) return f;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<FacetId> facetThrough(const FoldedState& state, const Edge& hinge) {
  if (!state.layers.areCoplanar(hinge.left, hinge.right)) return piercedBy(state, hinge);
  const Segment segment = segmentOf(state, hinge);
  for (const FacetId f : state.layers.sets()[state.layers.setOf(hinge.left)].upward) {
    if (f == hinge.left || f == hinge.right || !isBetween(state, f, hinge)) continue;
    if (runsThrough(state.pattern, state.poseOf(f), f, segment.from, segment.to)) return f;
  }
  if (std::abs(hinge.angle) == 180) return interleavedWith(state, hinge);
  return std::nullopt;
}

}  // namespace kiri
