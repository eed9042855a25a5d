// The fold lines of a whole crease pattern.
// SPDX-License-Identifier: MIT
#include "core/model/pattern_lines.h"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.h"

namespace kiri {
namespace {

/// Finds which hinges go on straight into each other.
class Runs {
 public:
  Runs(const CreasePattern& pattern, const std::vector<double>& targets)
      : pattern_(pattern), targets_(targets), joined_(pattern.edges.size()) {
    std::vector<std::vector<std::size_t>> at(pattern.vertices.size());
    for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
      if (pattern.edges[e].kind != EdgeKind::Hinge || targets[e] == 0) continue;
      at[pattern.edges[e].from.index].push_back(e);
      at[pattern.edges[e].to.index].push_back(e);
    }
    for (std::size_t v = 0; v < at.size(); ++v) joinThrough(VertexId(v), at[v]);
  }

  /// The lowest edge of the run.
  std::size_t firstOf(std::size_t edge) { return joined_.find(static_cast<std::uint32_t>(edge)); }

 private:
  Vec2 farEnd(std::size_t edge, VertexId vertex) const {
    const Edge& e = pattern_.edges[edge];
    return pattern_[e.from == vertex ? e.to : e.from];
  }

  /// True when the two hinges lie on one line, on the two sides of the vertex.
  bool goOn(VertexId vertex, std::size_t a, std::size_t b) const {
    if (std::abs(std::abs(targets_[a]) - std::abs(targets_[b])) > kSameAngle) return false;
    const Vec2 here = pattern_[vertex];
    const Vec2 toA = farEnd(a, vertex) - here;
    const Vec2 toB = farEnd(b, vertex) - here;
    if (dot(toA, toB) >= 0) return false;
    const double shorter = std::min(length(toA), length(toB));
    return std::abs(cross(toA, toB)) <= pattern_.tolerance.match() * shorter;
  }

  void joinThrough(VertexId vertex, const std::vector<std::size_t>& hinges) {
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      for (std::size_t k = i + 1; k < hinges.size(); ++k) {
        if (!goOn(vertex, hinges[i], hinges[k])) continue;
        joined_.join(static_cast<std::uint32_t>(hinges[i]), static_cast<std::uint32_t>(hinges[k]));
      }
    }
  }

  const CreasePattern& pattern_;
  const std::vector<double>& targets_;
  DisjointSets joined_;
};

}  // namespace

void makeFoldLines(FoldedState& state, const std::vector<double>& targets, FacetId resting,
                   const std::string& name) {
  CreasePattern& pattern = state.pattern;
  Runs runs(pattern, targets);
  const Vec2 still = interiorPointOf(pattern, resting);
  std::vector<FoldLineId> lineOf(pattern.edges.size());
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    Edge& edge = pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge || targets[e] == 0) continue;
    const std::size_t first = runs.firstOf(e);
    const Vec2 start = pattern[pattern.edges[first].from];
    const Vec2 along = pattern[pattern.edges[first].to] - start;
    if (first == e) {
      lineOf[e] = FoldLineId(state.lines.size());
      state.lines.push_back({name + " " + std::to_string(state.lines.size() + 1),
                             std::abs(targets[e]), targets[e] > 0});
    }
    edge.line = lineOf[first];
    const bool isAlike = dot(pattern[edge.to] - pattern[edge.from], along) > 0;
    edge.leftMoves = (cross(along, still - start) <= 0) == isAlike;
    edge.sign = targets[e] > 0 ? std::int8_t{1} : std::int8_t{-1};
  }
}

}  // namespace kiri
