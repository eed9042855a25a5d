// Layers lifted off each other, for pictures.
// SPDX-License-Identifier: MIT
#include "render/scene/spread.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/layers/layer_levels.h"
#include "core/paper/loose_facet.h"

namespace kiri {
namespace {

/// What is between the two sides of a hinge when layers are lifted.
struct Gap {
  EdgeId hinge;
  double height = 0;  ///< mm
};

std::vector<Gap> gapsOf(const FoldedState& state, const std::vector<Rigid>& lifted) {
  std::vector<Gap> gaps;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge) continue;
    const auto lift = [&](FacetId f) { return lifted[f.index].origin - state.poseOf(f).origin; };
    const double height = distance(lift(edge.left), lift(edge.right));
    if (height > state.tolerance().thin()) gaps.push_back({EdgeId(e), height});
  }
  // Strips at one fold lie in one plane; of two as near to the eye the one that comes first is
  // drawn, and it shall be the outer one.
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const Gap& a, const Gap& b) { return a.height > b.height; });
  return gaps;
}

/// The strip goes on from the left facet of the hinge as the paper does, up to the right one.
void addStrip(const FoldedState& state, const std::vector<Rigid>& lifted, EdgeId hinge,
              FoldedState& out) {
  const Edge edge = state.pattern[hinge];
  const Vec2 from = state.pattern[edge.from];
  const Vec2 to = state.pattern[edge.to];
  const Vec2 along = normalized(to - from);
  const Vec2 across = -perpendicular(along);  // away from the left facet
  const Rigid& left = lifted[edge.left.index];
  const Vec3 start = left.apply(from);
  const Vec3 rise = lifted[edge.right.index].apply(from) - start;
  const Vec3 alongInModel = normalized(left.apply(to) - start);
  const double skew = dot(rise, alongInModel);
  const Vec3 acrossInModel = rise - alongInModel * skew;
  const double width = length(acrossInModel);
  if (!(width > state.tolerance().thin())) return;

  Rigid pose;
  const Vec3 unit = acrossInModel / width;
  pose.x = alongInModel * along.x + unit * across.x;
  pose.y = alongInModel * along.y + unit * across.y;
  pose.z = cross(pose.x, pose.y);
  pose.origin = {};
  pose.origin = start - pose.apply(from);
  const Vec2 step = across * width + along * skew;
  const Vec2 corners[] = {from, from + step, to + step, to};
  addLooseFacet(out.pattern, corners);
  out.poses.push_back(pose);
}

}  // namespace

FoldedState spread(const FoldedState& state, double gap, bool isJoined) {
  FoldedState out = state;
  out.poses = spreadPoses(state, gap);
  const std::vector<Rigid> lifted = out.poses;
  const std::vector<std::uint32_t> levels = layerLevels(state);
  std::vector<LayerSet> sets;
  for (const LayerSet& set : state.layers.sets()) {
    std::map<std::uint32_t, LayerSet> byLevel;  // what shares a level does not overlap
    for (const FacetId facet : set.upward) {
      LayerSet& layer = byLevel[levels[facet.index]];
      layer.normal = set.normal;
      layer.upward.push_back(facet);
    }
    for (auto& [level, layer] : byLevel) sets.push_back(std::move(layer));
  }
  if (isJoined) {
    for (const Gap& open : gapsOf(state, lifted)) addStrip(state, lifted, open.hinge, out);
  }
  for (std::size_t f = state.pattern.facets.size(); f < out.pattern.facets.size(); ++f) {
    sets.push_back({out.poses[f].normal(), {FacetId(f)}, {}});
  }
  out.layers = LayerOrder(std::move(sets));
  return out;
}

}  // namespace kiri
