// SPDX-License-Identifier: MIT
#include "core/model/pattern_motion.h"

#include <algorithm>
#include <cmath>

#include "core/fold/group_motion.h"
#include "core/fold/path_collisions.h"
#include "core/layers/merge_orders.h"
#include "core/layers/plane_view.h"

namespace kiri {
namespace {

/// All hinges that turn; the one that turns most leads, the first of several.
PathRequest requestTo(const FoldedState& flat, const FoldedState& folded) {
  PathRequest request{anglesOf(folded.pattern), {}, {}};
  const FoldAngles from = anglesOf(flat.pattern);
  double most = 0;
  for (std::size_t e = 0; e < from.size(); ++e) {
    const double turn = std::abs(request.wanted[e] - from[e]);
    if (turn == 0) continue;
    if (turn > most) {
      if (!request.driven.empty()) request.free.push_back(request.driven.front());
      request.driven = {EdgeId(e)};
      most = turn;
    } else {
      request.free.push_back(EdgeId(e));
    }
  }
  return request;
}

FoldLineId leadingLine(const FoldedState& state) {
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge && edge.line.isValid()) return edge.line;
  }
  return FoldLineId(0);
}

/// True when every facet lies where it does in the other state.
bool liesAs(const FoldedState& a, const FoldedState& b) {
  for (std::size_t f = 0; f < a.poses.size(); ++f) {
    for (const EdgeUse use : a.pattern.facets[f].border) {
      const Vec2 p = a.pattern[startOf(a.pattern, use)];
      if (distance(a.poses[f].apply(p), b.poses[f].apply(p)) > a.tolerance().match()) return false;
    }
  }
  return true;
}

}  // namespace

PatternMotion patternMotion(const FoldedState& flat, const FoldedState& folded,
                            const Progress& progress) {
  PatternMotion motion;
  const PathRequest request = requestTo(flat, folded);
  if (request.driven.empty() || flat.pattern.facets.size() > kMostRigidFacets) {
    motion.way = request.driven.empty() ? PatternWay::Rigid : PatternWay::NotTried;
    return motion;
  }
  RigidPath path = rigidPath(flat, request, progress);
  if (!path.arrives()) return motion;
  motion.path = std::make_shared<const RigidPath>(std::move(path));
  const Movement movement = movementAlong(flat, motion.path, folded);
  motion.end = stateDuring(movement, 1);
  const FoldLineId leading = leadingLine(flat);
  const bool isFree = collisionsOnTheWay(movement, leading).empty() &&
                      collisionsAtTheEnd(movement, leading, *motion.end).empty();
  motion.way = isFree ? PatternWay::Rigid : PatternWay::MeetsItself;
  return motion;
}

Movements foldingOneByOne(const FoldedState& flat, const FoldedState& folded,
                          const Progress& progress) {
  constexpr std::size_t kMostLines = 64;
  constexpr std::size_t kMostFacets = 256;
  if (folded.lines.size() > kMostLines || folded.pattern.facets.size() > kMostFacets) return {};
  std::vector<FoldLineId> lines;
  for (std::size_t i = 0; i < folded.lines.size(); ++i) lines.emplace_back(i);
  Movements back;
  const Result<FoldedState> open = unfoldOneByOne(folded, lines, &back, progress);
  if (!open || open->collisions.size() > folded.collisions.size() || !liesAs(*open, flat))
    return {};
  Movements there;
  std::shared_ptr<const FoldedState> start = std::make_shared<const FoldedState>(flat);
  for (std::size_t i = back.size(); i-- > 0;) {
    Turning turning = std::get<Turning>(back[i].how);
    turning.motion.degrees = -turning.motion.degrees;
    there.push_back({start, std::move(turning)});
    const FoldedState end = stateDuring(there.back(), 1);
    if (!liesAs(end, *back[i].start) || !haveSameOrder(end, *back[i].start)) return {};
    start = back[i].start;
  }
  return there;
}

bool haveSameOrder(const FoldedState& a, const FoldedState& b) {
  for (const LayerSet& set : a.layers.sets()) {
    PlaneView view(a.pattern, a.poses, a.poseOf(set.upward.front()));
    for (const AbovePair& pair : relationsWithin(set, view)) {
      if (!b.layers.areCoplanar(pair.upper, pair.lower)) return false;
      const Vec3 other = b.layers.sets()[b.layers.setOf(pair.upper)].normal;
      const bool isUp = dot(other, set.normal) > 0;
      if (b.layers.isAbove(pair.upper, pair.lower) != isUp) return false;
    }
  }
  return true;
}

std::string sentenceOf(PatternWay way) {
  switch (way) {
    case PatternWay::Rigid:
    case PatternWay::OneByOne:
      return "";
    case PatternWay::MustBend:
      return "the paper must bend between the flat sheet and the folded state: no motion with "
             "rigid facets was found, so none is shown";
    case PatternWay::MeetsItself:
      return "the paper must bend between the flat sheet and the folded state: with rigid facets "
             "it would pass through itself, so no motion is shown";
    case PatternWay::NotTried:
      return "no motion between the flat sheet and the folded state is shown: the pattern has more "
             "than " +
             std::to_string(kMostRigidFacets) +
             " facets, which is more than are followed; most such models bend on the way";
  }
  return "";
}

}  // namespace kiri
