// SPDX-License-Identifier: MIT
#include "core/model/pattern_order.h"

#include <cmath>
#include <string>

#include "core/base/text.h"
#include "core/layers/hinge_conflicts.h"
#include "core/layers/merge_orders.h"
#include "core/layers/order_by_height.h"
#include "core/model/facet_finder.h"
#include "core/model/pattern_layers.h"
#include "core/sweep/pierced.h"

namespace kiri {
namespace {

Collision described(const FoldedState& state, FacetId first, FacetId second) {
  Collision c;
  c.moment = CollisionMoment::End;
  c.moving = interiorPointOf(state.pattern, first);
  c.fixed = interiorPointOf(state.pattern, second);
  c.place = state.poseOf(first).apply(c.moving);
  c.message = "as the pattern is folded, the paper at " + text(c.moving) +
              " mm passes through the paper at " + text(c.fixed) +
              " mm; choose another order of the layers, or leave them out to have one found";
  return c;
}

}  // namespace

AssignedPattern targetsOf(const FoldedState& folded, const std::vector<Assignment>& assignments) {
  AssignedPattern creases(folded.pattern);
  creases.assignments = assignments;
  return creases;
}

Status searchLayers(FoldedState& folded, const std::vector<Assignment>&, const Progress&) {
  folded.layers = unorderedLayers(folded);
  return std::monostate{};
}

void orderPartly(FoldedState& folded) {
  constexpr double kMomentBefore = 1.0 / 128;
  CreasePattern earlier = folded.pattern;
  for (Edge& edge : earlier.edges) edge.angle *= 1 - kMomentBefore;
  folded.layers = unorderedLayers(folded);
  folded.layers = orderByHeight(folded, folded.poses, derivePoses(earlier, folded.rests));
}

void orderAs(FoldedState& folded, const std::vector<DrawnOrder>& orders) {
  const FacetFinder finder(folded.pattern);
  std::vector<std::vector<AbovePair>> pairs(folded.layers.sets().size());
  for (const DrawnOrder& order : orders) {
    const std::optional<FacetId> upper = finder.at(order.upper);
    const std::optional<FacetId> lower = finder.at(order.lower);
    if (!upper || !lower || *upper == *lower || !folded.layers.areCoplanar(*upper, *lower))
      continue;
    const std::uint32_t set = folded.layers.setOf(*upper);
    const Vec3 up = folded.layers.sets()[set].normal;
    const bool isUp = (dot(up, folded.poseOf(*lower).normal()) > 0) == order.isFront;
    pairs[set].push_back(isUp ? AbovePair{*upper, *lower} : AbovePair{*lower, *upper});
  }
  std::vector<LayerSet> sets;
  for (std::size_t s = 0; s < pairs.size(); ++s) {
    const LayerSet& listed = folded.layers.sets()[s];
    sets.push_back(mergedOrder(listed, {listed.normal, {}, {}}, pairs[s]));
  }
  folded.layers = LayerOrder(std::move(sets));
}

void directUnassigned(FoldedState& folded, const std::vector<Assignment>& assignments) {
  for (std::size_t e = 0; e < assignments.size(); ++e) {
    Edge& edge = folded.pattern.edges[e];
    const bool isOpen = assignments[e] == Assignment::Unassigned && edge.kind == EdgeKind::Hinge;
    if (!isOpen || std::abs(edge.angle) != 180) continue;
    if (!folded.layers.areCoplanar(edge.left, edge.right)) continue;
    const LayerSet& set = folded.layers.sets()[folded.layers.setOf(edge.left)];
    // A valley lays the right facet onto the front of the left one.
    const bool isUp = dot(set.normal, folded.poseOf(edge.left).normal()) > 0;
    edge.angle = folded.layers.isAbove(edge.right, edge.left) == isUp ? 180 : -180;
  }
}

std::optional<Collision> faultOf(const FoldedState& folded) {
  if (!isFlat(folded)) {
    if (const std::optional<Pierced> pierced = firstPierced(folded)) {
      Collision c = described(folded, pierced->first, pierced->second);
      c.place = pierced->place;
      c.isCertain = pierced->isCertain;
      return c;
    }
  }
  for (std::size_t set = 0; set < folded.layers.sets().size(); ++set) {
    const std::vector<HingeConflict> found =
        hingeConflicts(folded.pattern, folded.poses, folded.layers, set, {{}, 1});
    if (!found.empty()) return described(folded, found.front().first[0], found.front().second[0]);
  }
  return std::nullopt;
}

}  // namespace kiri
