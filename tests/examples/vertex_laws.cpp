// Counts and adds up around each vertex.
// SPDX-License-Identifier: MIT
#include "tests/examples/vertex_laws.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace kiri::test {
namespace {

struct Spoke {
  double direction = 0;  // degrees
  bool isValley = true;
};

}  // namespace

VertexLaws vertexLawsOf(const FoldedState& state) {
  const CreasePattern& pattern = state.pattern;
  std::vector<std::vector<Spoke>> spokes(pattern.vertices.size());
  std::vector<bool> isFree(pattern.vertices.size(), true);
  for (const Edge& edge : pattern.edges) {
    for (const auto& [here, there] :
         {std::pair(edge.from, edge.to), std::pair(edge.to, edge.from)}) {
      if (edge.kind != EdgeKind::Hinge) isFree[here.index] = false;
      if (edge.kind != EdgeKind::Hinge || edge.angle == 0) continue;
      const Vec2 d = pattern[there] - pattern[here];
      spokes[here.index].push_back({std::atan2(d.y, d.x) * 180 / std::numbers::pi, edge.angle > 0});
    }
  }
  VertexLaws laws;
  for (std::size_t v = 0; v < spokes.size(); ++v) {
    std::vector<Spoke>& around = spokes[v];
    if (!isFree[v] || around.empty()) continue;
    ++laws.vertexCount;
    std::sort(around.begin(), around.end(),
              [](const Spoke& a, const Spoke& b) { return a.direction < b.direction; });
    double even = 0;
    int surplus = 0;
    for (std::size_t i = 0; i < around.size(); ++i) {
      surplus += around[i].isValley ? 1 : -1;
      if (i % 2 == 1) even += around[i].direction - around[i - 1].direction;
    }
    const std::string place = " at (" + std::to_string(pattern.vertices[v].x) + ", " +
                              std::to_string(pattern.vertices[v].y) + ")";
    if (std::abs(surplus) != 2) {
      laws.faults.push_back("Maekawa: surplus " + std::to_string(surplus) + place);
    }
    if (around.size() % 2 != 0 || std::abs(even - 180) > 1e-6) {
      laws.faults.push_back("Kawasaki: " + std::to_string(even) + " degrees of " +
                            std::to_string(around.size()) + " creases" + place);
    }
  }
  return laws;
}

}  // namespace kiri::test
