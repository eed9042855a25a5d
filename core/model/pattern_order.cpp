// SPDX-License-Identifier: MIT
#include "core/model/pattern_order.h"

#include <cmath>
#include <string>

#include "core/base/text.h"
#include "core/flatfold/flat_folding.h"
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

/// Paper through paper along the hinges of a plane.
std::optional<Collision> hingeFault(const FoldedState& folded) {
  for (std::size_t set = 0; set < folded.layers.sets().size(); ++set) {
    const std::vector<HingeConflict> found =
        hingeConflicts(folded.pattern, folded.poses, folded.layers, set, {{}, 1});
    if (!found.empty()) return described(folded, found.front().first[0], found.front().second[0]);
  }
  return std::nullopt;
}

/// The poses of a flat state as the resting facet sees them, in its own paper frame.
FlatMap mapOf(const FoldedState& folded) {
  const Rigid& home = folded.poseOf(folded.rests.front().facet);
  FlatMap map;
  for (const Rigid& pose : folded.poses) {
    FlatPose flat;
    flat.x = {dot(pose.x, home.x), dot(pose.x, home.y)};
    flat.y = {dot(pose.y, home.x), dot(pose.y, home.y)};
    flat.origin = home.pullBack(pose.origin);
    flat.isFlipped = dot(pose.normal(), home.normal()) < 0;
    map.poses.push_back(flat);
  }
  map.vertices.resize(folded.pattern.vertices.size());
  for (std::size_t f = map.poses.size(); f-- > 0;) {
    for (const EdgeUse use : folded.pattern.facets[f].border) {
      const VertexId v = startOf(folded.pattern, use);
      map.vertices[v.index] = map.poses[f].apply(folded.pattern[v]);
    }
  }
  map.error = stretchOf(folded);
  return map;
}

Result<GroundAndOrders> groundOf(const FoldedState& folded,
                                 const std::vector<Assignment>& assignments,
                                 const Progress& progress) {
  if (!folded.pattern.curves.empty()) {
    return Error{ErrorCode::BadValue,
                 "layers are searched for on sheets with straight sides only; give the layers, or "
                 "leave the pattern flat",
                 {}};
  }
  AssignedPattern creases(folded.pattern);
  creases.assignments = assignments;
  return overlapsOf(creases, mapOf(folded), progress);
}

Error noOrder(const FoldedState& folded, const OrderConflict& conflict) {
  Error error{
      ErrorCode::BadValue,
      "the pattern folds flat as a map, but its layers cannot be ordered: " + conflict.message,
      {}};
  for (const FacetId f : conflict.facets)
    error.witness.facets.push_back(interiorPointOf(folded.pattern, f));
  return error;
}

/// An order as the facets have it: none where the places are no two facets.
struct FacetOrder {
  FacetId upper;  ///< farther along the front of the resting facet
  FacetId lower;
};

std::vector<FacetOrder> facetOrders(const FoldedState& folded,
                                    const std::vector<DrawnOrder>& orders) {
  const FacetFinder finder(folded.pattern);
  std::vector<FacetOrder> found;
  for (const DrawnOrder& order : orders) {
    const std::optional<FacetId> upper = finder.at(order.upper);
    const std::optional<FacetId> lower = finder.at(order.lower);
    if (!upper || !lower || *upper == *lower) continue;
    if (!folded.layers.areCoplanar(*upper, *lower)) continue;
    const Vec3 up = folded.layers.sets()[folded.layers.setOf(*upper)].normal;
    const bool isUp = (dot(up, folded.poseOf(*lower).normal()) > 0) == order.isFront;
    found.push_back(isUp ? FacetOrder{*upper, *lower} : FacetOrder{*lower, *upper});
  }
  return found;
}

std::vector<Literal> literalsOf(const FoldedState& folded, const OrderProblem& problem,
                                const std::vector<DrawnOrder>& orders) {
  const Vec3 front = folded.poseOf(folded.rests.front().facet).normal();
  std::vector<Literal> literals;
  for (const FacetOrder& order : facetOrders(folded, orders)) {
    const Vec3 up = folded.layers.sets()[folded.layers.setOf(order.upper)].normal;
    const bool isUp = dot(up, front) > 0;
    const FacetId a = isUp ? order.upper : order.lower;
    const FacetId b = isUp ? order.lower : order.upper;
    const std::uint32_t pair = problem.indexOf(std::min(a, b), std::max(a, b));
    if (pair != OrderProblem::kNone) literals.emplace_back(pair, b < a);
  }
  return literals;
}

/// The rule that the layers of a flat state break; none where that cannot be found out so.
std::optional<std::string> brokenRuleOf(const FoldedState& folded) {
  std::vector<Assignment> assignments;
  for (const Edge& edge : folded.pattern.edges) {
    assignments.push_back(edge.kind != EdgeKind::Hinge ? Assignment::Cut
                          : edge.angle > 0             ? Assignment::Valley
                          : edge.angle < 0             ? Assignment::Mountain
                                                       : Assignment::Flat);
  }
  const Result<GroundAndOrders> ground = groundOf(folded, assignments, {});
  if (!ground) return std::nullopt;
  const Vec3 front = folded.poseOf(folded.rests.front().facet).normal();
  LayerValues values;
  for (const FacetPair& pair : ground->problem.pairs) {
    if (!folded.layers.areCoplanar(pair.a, pair.b)) return "facets of one plane are not ordered";
    const Vec3 up = folded.layers.sets()[folded.layers.setOf(pair.a)].normal;
    values.push_back(folded.layers.isAbove(pair.a, pair.b) == (dot(up, front) > 0));
  }
  return brokenRule(ground->problem, values);
}

}  // namespace

Result<bool> searchLayers(FoldedState& folded, const std::vector<Assignment>& assignments,
                          const std::vector<DrawnOrder>& wanted, const Progress& progress) {
  Result<GroundAndOrders> ground = groundOf(folded, assignments, progress);
  if (!ground) return ground.error();
  Result<LayerStates> states = LayerStates::find(std::move(ground->problem), {}, progress);
  if (!states) return states.error();
  if (!states->exist()) return noOrder(folded, states->conflict());
  LayerValues values = states->first();
  bool isAsWanted = true;
  if (!wanted.empty()) {
    Result<LayerValues> as =
        states->stateWith(literalsOf(folded, states->problem(), wanted), values, progress);
    isAsWanted = as.isOk();
    if (isAsWanted) values = std::move(*as);
  }
  std::vector<LayerSet> sets = layerOrderOf(states->problem(), values).sets();
  sets.front().normal = folded.poseOf(folded.rests.front().facet).normal();
  folded.layers = LayerOrder(std::move(sets));
  return isAsWanted;
}

void orderPartly(FoldedState& folded) {
  constexpr double kMomentBefore = 1.0 / 128;
  CreasePattern earlier = folded.pattern;
  for (Edge& edge : earlier.edges) edge.angle *= 1 - kMomentBefore;
  folded.layers = unorderedLayers(folded);
  folded.layers = orderByHeight(folded, folded.poses, derivePoses(earlier, folded.rests));
}

void orderAs(FoldedState& folded, const std::vector<DrawnOrder>& orders) {
  std::vector<std::vector<AbovePair>> pairs(folded.layers.sets().size());
  for (const FacetOrder& order : facetOrders(folded, orders))
    pairs[folded.layers.setOf(order.upper)].push_back({order.upper, order.lower});
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
  if (isFlat(folded) && folded.pattern.curves.empty()) {
    const std::optional<std::string> rule = brokenRuleOf(folded);
    if (!rule) return std::nullopt;
    // Where it is, is seen along the hinges; in large patterns that takes long.
    constexpr std::size_t kFew = 1000;
    if (folded.pattern.facets.size() <= kFew) {
      if (std::optional<Collision> seen = hingeFault(folded)) return seen;
    }
    Collision c = described(folded, FacetId(0), FacetId(0));
    c.message = "in the order of the layers that the pattern has, " + *rule +
                "; choose another order, or leave the layers out to have one found";
    return c;
  }
  if (const std::optional<Pierced> pierced = firstPierced(folded)) {
    Collision c = described(folded, pierced->first, pierced->second);
    c.place = pierced->place;
    c.isCertain = pierced->isCertain;
    return c;
  }
  return hingeFault(folded);
}

}  // namespace kiri
