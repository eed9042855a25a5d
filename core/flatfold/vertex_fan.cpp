// Creases are sorted by direction. SPDX-License-Identifier: MIT
#include "core/flatfold/vertex_fan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kiri {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
/// Whatever the drawing: more than this, in degrees, is no want of precision.
constexpr double kCoarsest = 0.5;

struct Outward {
  double direction = 0;  ///< degrees
  EdgeId crease;
  auto operator<=>(const Outward&) const = default;
};

}  // namespace

double VertexFan::kawasakiMiss() const {
  double sum = 0;
  for (std::size_t i = 0; i < sectors.size(); i += 2) sum += sectors[i];
  return std::abs(sum - 180);
}

double VertexFan::explainedBy(double precision) const {
  return std::max(kSameAngle, std::min(kCoarsest, slack * precision));
}

std::vector<VertexFan> fansInside(const AssignedPattern& creases) {
  const CreasePattern& pattern = creases.pattern;
  std::vector<std::vector<Outward>> around(pattern.vertices.size());
  std::vector<bool> isInside(pattern.vertices.size(), true);
  std::vector<double> slack(pattern.vertices.size(), 0);
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge) {
      isInside[edge.from.index] = false;
      isInside[edge.to.index] = false;
      continue;
    }
    if (!creases.isFolded(EdgeId(e))) continue;
    const Vec2 d = pattern[edge.to] - pattern[edge.from];
    for (const VertexId v : {edge.from, edge.to}) {
      const Vec2 out = v == edge.from ? d : -d;
      around[v.index].push_back({std::atan2(out.y, out.x) * kDegrees, EdgeId(e)});
      // Either end may be off, and every crease bounds two sectors.
      slack[v.index] += 2 * kDegrees / length(d);
    }
  }
  std::vector<VertexFan> fans;
  for (std::size_t v = 0; v < around.size(); ++v) {
    std::vector<Outward>& out = around[v];
    if (!isInside[v] || out.empty()) continue;
    std::sort(out.begin(), out.end());
    VertexFan fan{VertexId(v), {}, {}, slack[v]};
    for (std::size_t i = 0; i < out.size(); ++i) {
      const bool isLast = i + 1 == out.size();
      const double next = isLast ? out.front().direction + 360 : out[i + 1].direction;
      fan.creases.push_back(out[i].crease);
      fan.sectors.push_back(next - out[i].direction);
    }
    fans.push_back(std::move(fan));
  }
  return fans;
}

}  // namespace kiri
