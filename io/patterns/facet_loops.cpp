// The facets of a pattern as single loops of vertices, as FOLD wants its faces.
// SPDX-License-Identifier: MIT
#include "io/patterns/facet_loops.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "core/base/check.h"

namespace kiri {

namespace {

using VertexLoop = std::vector<std::uint32_t>;

double sideOf(Vec2 a, Vec2 b, Vec2 p) { return cross(b - a, p - a); }

/// True when the open segment p-q crosses a-b. Segments that share an end, or where one end lies on
/// the other's line, do not: the shortest join is free of those but where it does no harm.
bool crosses(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
  return sideOf(p, q, a) * sideOf(p, q, b) < 0 && sideOf(a, b, p) * sideOf(a, b, q) < 0;
}

std::vector<VertexLoop> loopsOf(const CreasePattern& pattern, const Facet& facet) {
  std::vector<VertexLoop> loops(1);
  std::size_t next = 0;
  for (std::size_t i = 0; i < facet.border.size(); ++i) {
    if (next < facet.holeStarts.size() && facet.holeStarts[next] == i) {
      loops.emplace_back();
      ++next;
    }
    loops.back().push_back(startOf(pattern, facet.border[i]).index);
  }
  return loops;
}

/// Joins holes to the outline one after the other, each along the shortest way that is free.
class HoleJoiner {
 public:
  HoleJoiner(const CreasePattern& pattern, const Facet& facet) : pattern_(pattern), facet_(facet) {}

  void join(VertexLoop& outline, std::vector<VertexLoop> holes) {
    while (!holes.empty()) {
      const Bridge bridge = shortest(outline, holes);
      VertexLoop& hole = holes[bridge.hole];
      std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(bridge.to), hole.end());
      hole.push_back(hole.front());
      joins.emplace_back(outline[bridge.from], hole.front());
      const std::uint32_t again = outline[bridge.from];
      const auto at = outline.begin() + static_cast<std::ptrdiff_t>(bridge.from) + 1;
      const auto end = outline.insert(at, hole.begin(), hole.end());
      outline.insert(end + static_cast<std::ptrdiff_t>(hole.size()), again);
      holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(bridge.hole));
    }
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> joins;

 private:
  struct Bridge {
    std::size_t from = 0;  ///< in the outline
    std::size_t hole = 0;
    std::size_t to = 0;  ///< in the hole
  };

  Vec2 at(std::uint32_t vertex) const { return pattern_.vertices[vertex]; }

  bool isFree(Vec2 p, Vec2 q) const {
    for (const EdgeUse use : facet_.border) {
      if (crosses(p, q, pattern_[startOf(pattern_, use)], pattern_[endOf(pattern_, use)]))
        return false;
    }
    return std::none_of(joins.begin(), joins.end(), [&](const auto& join) {
      return crosses(p, q, at(join.first), at(join.second));
    });
  }

  Bridge shortest(const VertexLoop& outline, const std::vector<VertexLoop>& holes) const {
    Bridge best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t h = 0; h < holes.size(); ++h) {
      for (std::size_t j = 0; j < holes[h].size(); ++j) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
          const Vec2 p = at(outline[i]);
          const Vec2 q = at(holes[h][j]);
          const double distance = length(q - p);
          if (distance >= least || !isFree(p, q)) continue;
          least = distance;
          best = {i, h, j};
        }
      }
    }
    return best;
  }

  const CreasePattern& pattern_;
  const Facet& facet_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> faceEdges(
    const std::vector<std::vector<std::uint32_t>>& faces, const std::vector<FoldEdge>& edges) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> between;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto ends = std::minmax(edges[i].from, edges[i].to);
    between.emplace(ends, static_cast<std::uint32_t>(i));
  }
  std::vector<std::vector<std::uint32_t>> out;
  out.reserve(faces.size());
  for (const std::vector<std::uint32_t>& face : faces) {
    std::vector<std::uint32_t>& sides = out.emplace_back();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto found = between.find(std::minmax(face[i], face[(i + 1) % face.size()]));
      KIRI_CHECK(found != between.end(), "every side of a face is an edge");
      sides.push_back(found->second);
    }
  }
  return out;
}

FacetLoops facetLoopsOf(const AssignedPattern& creases) {
  const CreasePattern& pattern = creases.pattern;
  FacetLoops out;
  out.assignments = creases.assignments;
  for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
    const Edge& edge = pattern.edges[i];
    out.edges.push_back({edge.from.index, edge.to.index, edge.left, edge.right, EdgeId(i), false});
  }
  for (std::size_t f = 0; f < pattern.facets.size(); ++f) {
    std::vector<VertexLoop> loops = loopsOf(pattern, pattern.facets[f]);
    VertexLoop outline = std::move(loops.front());
    if (loops.size() > 1) {
      loops.erase(loops.begin());
      HoleJoiner joiner(pattern, pattern.facets[f]);
      joiner.join(outline, std::move(loops));
      for (const auto& [from, to] : joiner.joins) {
        out.edges.push_back({from, to, FacetId(f), FacetId(f), EdgeId(), false});
        out.assignments.push_back(Assignment::Join);
        ++out.joins;
      }
    }
    out.faces.push_back(std::move(outline));
  }
  return out;
}

}  // namespace kiri
