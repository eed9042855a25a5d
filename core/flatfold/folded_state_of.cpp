// A chosen layer order becomes a state of the kernel.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <queue>

#include "core/flatfold/flat_folding.h"

namespace kiri {
namespace {

/// For each facet those that lie above it, as a graph in one list.
struct UpperFacets {
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> uppers;
  std::vector<std::uint32_t> lowerCounts;  ///< by facet: how many lie below it
};

struct Stacked {
  std::uint32_t upper;
  std::uint32_t lower;
};

Stacked stackedOf(const OrderProblem& problem, const LayerValues& values, std::size_t pair) {
  const FacetPair& facets = problem.pairs[pair];
  return values[pair] ? Stacked{facets.a.index, facets.b.index}
                      : Stacked{facets.b.index, facets.a.index};
}

UpperFacets upperFacets(const OrderProblem& problem, const LayerValues& values) {
  UpperFacets graph;
  graph.starts.assign(problem.facetCount + 1, 0);
  graph.lowerCounts.assign(problem.facetCount, 0);
  for (std::size_t p = 0; p < problem.pairs.size(); ++p) {
    const Stacked stacked = stackedOf(problem, values, p);
    ++graph.starts[stacked.lower + 1];
    ++graph.lowerCounts[stacked.upper];
  }
  for (std::size_t f = 0; f < problem.facetCount; ++f) graph.starts[f + 1] += graph.starts[f];
  graph.uppers.resize(problem.pairs.size());
  std::vector<std::uint32_t> next(graph.starts.begin(), graph.starts.end() - 1);
  for (std::size_t p = 0; p < problem.pairs.size(); ++p) {
    const Stacked stacked = stackedOf(problem, values, p);
    graph.uppers[next[stacked.lower]++] = stacked.upper;
  }
  return graph;
}

/// Bottom to top: the first facet with nothing left beneath it; in a ring, the one with least.
std::vector<FacetId> upwardList(UpperFacets graph) {
  const std::size_t count = graph.lowerCounts.size();
  using Ready = std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>>;
  Ready ready;
  for (std::uint32_t f = 0; f < count; ++f) {
    if (graph.lowerCounts[f] == 0) ready.push(f);
  }
  std::vector<bool> isTaken(count, false);
  std::vector<FacetId> upward;
  while (upward.size() < count) {
    std::uint32_t best = OrderProblem::kNone;
    if (!ready.empty()) {
      best = ready.top();
      ready.pop();
    } else {
      for (std::uint32_t f = 0; f < count; ++f) {
        if (isTaken[f]) continue;
        if (best == OrderProblem::kNone || graph.lowerCounts[f] < graph.lowerCounts[best]) best = f;
      }
    }
    isTaken[best] = true;
    upward.push_back(FacetId(best));
    for (std::uint32_t i = graph.starts[best]; i < graph.starts[best + 1]; ++i) {
      const std::uint32_t upper = graph.uppers[i];
      if (!isTaken[upper] && --graph.lowerCounts[upper] == 0) ready.push(upper);
    }
  }
  return upward;
}

}  // namespace

LayerOrder layerOrderOf(const OrderProblem& problem, const LayerValues& values) {
  if (problem.facetCount == 0) return {};
  LayerSet set{{0, 0, 1}, upwardList(upperFacets(problem, values)), {}};
  std::vector<std::uint32_t> rank(problem.facetCount);
  for (std::uint32_t r = 0; r < set.upward.size(); ++r) rank[set.upward[r].index] = r;
  for (std::size_t p = 0; p < problem.pairs.size(); ++p) {
    const Stacked stacked = stackedOf(problem, values, p);
    if (rank[stacked.upper] > rank[stacked.lower]) continue;
    set.exceptions.insert({FacetId(stacked.upper), FacetId(stacked.lower)});
  }
  return LayerOrder({std::move(set)});
}

namespace {

bool isAsOnPaper(const FlatPose& pose) {
  return pose.x == Vec2{1, 0} && pose.y == Vec2{0, 1} && pose.origin == Vec2{0, 0};
}

/// For each piece the largest of the facets that lie as on the paper.
std::vector<Rest> restsOf(const CreasePattern& pattern, const FlatMap& map) {
  const std::vector<std::uint32_t> pieces = piecesOf(pattern);
  const std::uint32_t count = *std::max_element(pieces.begin(), pieces.end()) + 1;
  std::vector<Rest> rests(count);
  std::vector<double> areas(count, 0);
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    if (!isAsOnPaper(map.poses[f])) continue;
    const double area = areaOf(regionOf(pattern, FacetId(f)));
    if (area <= areas[pieces[f]]) continue;
    areas[pieces[f]] = area;
    rests[pieces[f]].facet = FacetId(f);
  }
  return rests;
}

}  // namespace

FoldedState foldedStateOf(const AssignedPattern& creases, const OrderProblem& problem,
                          const LayerValues& values) {
  const Result<FlatMap> map = flatMapOf(creases);
  KIRI_CHECK(map.isOk(), "a pattern with layer orders folds flat");
  FoldedState state(creases.pattern);
  if (state.pattern.facets.empty()) return state;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    Edge& edge = state.pattern.edges[e];
    if (!creases.isFolded(EdgeId(e))) continue;
    // The fronts of a valley's facets face each other: the upper one has its front down.
    const Literal rightAbove = problem.above(edge.right, edge.left);
    const bool isRightAbove = values[rightAbove.pair()] != rightAbove.isNegated();
    edge.angle = isRightAbove != map->poses[edge.left.index].isFlipped ? 180 : -180;
  }
  state.rests = restsOf(state.pattern, *map);
  state.poses = derivePoses(state.pattern, state.rests);
  state.layers = layerOrderOf(problem, values);
  return state;
}

}  // namespace kiri
