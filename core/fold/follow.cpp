// SPDX-License-Identifier: MIT
#include "core/fold/follow.h"

#include <algorithm>
#include <cmath>

#include "core/fold/fold_line.h"
#include "core/fold/movement.h"
#include "core/fold/path_collisions.h"

namespace kiri {
namespace {

/// Vertices around which paper that holds together goes all the way.
std::vector<bool> innerVertices(const CreasePattern& pattern) {
  std::vector<bool> isInner(pattern.vertices.size(), true);
  for (const Edge& edge : pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) continue;
    isInner[edge.from.index] = false;
    isInner[edge.to.index] = false;
  }
  return isInner;
}

/// The hinges of fold lines that hang together with those of `line` by vertices inside the paper.
std::vector<EdgeId> clusterOf(const FoldedState& state, FoldLineId line) {
  const CreasePattern& pattern = state.pattern;
  std::vector<bool> mayJoin = innerVertices(pattern);
  std::vector<std::vector<EdgeId>> at(pattern.vertices.size());
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge || !edge.line.isValid()) continue;
    at[edge.from.index].push_back(EdgeId(e));
    at[edge.to.index].push_back(EdgeId(e));
  }
  std::vector<EdgeId> cluster = hingesOf(state, line);
  std::vector<bool> isIn(pattern.edges.size(), false);
  for (const EdgeId id : cluster) isIn[id.index] = true;
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    for (const VertexId v : {pattern[cluster[i]].from, pattern[cluster[i]].to}) {
      if (!mayJoin[v.index]) continue;
      mayJoin[v.index] = false;
      for (const EdgeId next : at[v.index]) {
        if (isIn[next.index]) continue;
        isIn[next.index] = true;
        cluster.push_back(next);
      }
    }
  }
  return cluster;
}

/// The line leads with its longest hinge; the others head for the same share of their folds.
PathRequest requestFor(const FoldedState& state, FoldLineId line, double amount) {
  const CreasePattern& pattern = state.pattern;
  PathRequest request{anglesOf(pattern), {}, {}};
  const std::vector<EdgeId> own = hingesOf(state, line);
  const auto spanOf = [&](EdgeId id) {
    return distance(pattern[pattern[id].from], pattern[pattern[id].to]);
  };
  const EdgeId leader = *std::max_element(
      own.begin(), own.end(), [&](EdgeId a, EdgeId b) { return spanOf(a) < spanOf(b); });
  const Edge& leading = pattern[leader];
  const double full = state.lines[line.index].foldedAmount;
  for (const EdgeId id : clusterOf(state, line)) {
    const Edge& edge = pattern[id];
    double& wanted = request.wanted[id.index];
    if (edge.line == line) {
      wanted = edge.sign * amount;
    } else if (leading.angle != 0) {
      wanted = std::clamp(edge.angle * (leading.sign * amount / leading.angle), -180.0, 180.0);
    } else {
      wanted = edge.sign * state.lines[edge.line.index].foldedAmount * (amount / full);
    }
    if (id != leader) request.free.push_back(id);
  }
  request.driven.push_back(leader);
  return request;
}

/// Creases that come to lie flat but for rounding are meant to lie flat.
FoldAngles tidied(FoldAngles angles) {
  constexpr double kNearlyFlat = 1.0 / 4096;
  for (double& angle : angles) {
    const double flat = 180 * std::round(angle / 180);
    if (std::abs(angle - flat) <= kNearlyFlat) angle = flat;
  }
  return angles;
}

}  // namespace

std::optional<Followed> follow(const FoldedState& state, FoldLineId line, double amount) {
  PathRequest request = requestFor(state, line, amount);
  const EdgeId leader = request.driven.front();
  RigidPath found = rigidPath(state, request);
  if (found.reach() <= 0) return std::nullopt;
  if (found.isComplete() && !found.arrives()) {
    request.wanted = tidied(found.at(1));
    RigidPath tidy = rigidPath(state, request);
    if (tidy.arrives()) found = std::move(tidy);
  }
  const auto path = std::make_shared<const RigidPath>(std::move(found));
  const double reached = state.pattern[leader].sign * path->at(path->reach())[leader.index];
  return Followed{path, reached};
}

FoldedState stateFollowing(const FoldedState& state, FoldLineId line, const Followed& followed) {
  const std::shared_ptr<const RigidPath>& path = followed.path;
  FoldedState end = stateDuring(movementAlong(state, path, state), path->reach());
  for (std::size_t i = 0; i < end.lines.size(); ++i) {
    const std::optional<double> now = amountOf(end, FoldLineId(i));
    if (now && *now != 0 && now != amountOf(state, FoldLineId(i))) end.lines[i].foldedAmount = *now;
  }
  notePathCollisions(movementAlong(state, path, end), line, end);
  return end;
}

}  // namespace kiri
