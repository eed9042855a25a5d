// SPDX-License-Identifier: MIT
#include "core/linkage/rigid_path.h"

#include <algorithm>

namespace kiri {
namespace {

FoldAngles mixed(const FoldAngles& a, const FoldAngles& b, double part) {
  FoldAngles result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + (b[i] - a[i]) * part;
  return result;
}

}  // namespace

FoldAngles anglesOf(const CreasePattern& pattern) {
  FoldAngles angles;
  for (const Edge& edge : pattern.edges)
    angles.push_back(edge.kind == EdgeKind::Hinge ? edge.angle : 0);
  return angles;
}

double closureError(const CreasePattern& pattern, const std::vector<Rest>& rests,
                    const FoldAngles& angles) {
  CreasePattern bent = pattern;
  for (std::size_t e = 0; e < angles.size(); ++e) bent.edges[e].angle = angles[e];
  const std::vector<Rigid> poses = derivePoses(bent, rests);
  double most = 0;
  for (const Edge& edge : bent.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    for (const VertexId v : {edge.from, edge.to}) {
      const Vec2 p = bent[v];
      const Vec3 gap = poses[edge.left.index].apply(p) - poses[edge.right.index].apply(p);
      most = std::max(most, length(gap));
    }
  }
  return most;
}

RigidPath::RigidPath(const CreasePattern&, PathRequest, std::vector<Sample> samples)
    : samples_(std::move(samples)) {}

FoldAngles RigidPath::at(double part) const {
  return mixed(samples_.front().angles, samples_.back().angles, part);
}

std::optional<RigidPath> rigidPath(const FoldedState& state, const PathRequest& request,
                                   const Progress&) {
  const FoldAngles start = anglesOf(state.pattern);
  constexpr int kLooks = 16;
  for (int i = 1; i <= kLooks; ++i) {
    const FoldAngles angles = mixed(start, request.wanted, i / static_cast<double>(kLooks));
    if (closureError(state.pattern, state.rests, angles) > state.tolerance().match())
      return std::nullopt;
  }
  return RigidPath(state.pattern, request, {{0, start}, {1, request.wanted}});
}

}  // namespace kiri
