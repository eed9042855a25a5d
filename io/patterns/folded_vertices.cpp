// Where the vertices of a pattern lie when it is folded flat, split where cut paper lies apart.
// SPDX-License-Identifier: MIT
#include "io/patterns/folded_vertices.h"

#include <algorithm>

namespace kiri {

namespace {

/// Copies of one vertex: each is shared by facets that agree about where it lies.
class VertexCopies {
 public:
  VertexCopies(const AssignedPattern& creases, const FlatMap& map)
      : creases_(creases),
        map_(map),
        reach_(std::max(2 * map.error, creases.pattern.tolerance.match())),
        copies_(creases.pattern.vertices.size()) {
    for (std::size_t v = 0; v < copies_.size(); ++v) {
      copies_[v].push_back(static_cast<std::uint32_t>(v));
      points.push_back(map.vertices[v]);
      paper.push_back(creases.pattern.vertices[v]);
    }
  }

  /// The copy of the vertex that belongs to the facet; made where there is none.
  std::uint32_t of(std::uint32_t vertex, FacetId facet) {
    const Vec2 place = map_.poses[facet.index].apply(creases_.pattern.vertices[vertex]);
    for (const std::uint32_t copy : copies_[vertex]) {
      if (length(points[copy] - place) <= reach_) return copy;
    }
    copies_[vertex].push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(place);
    paper.push_back(creases_.pattern.vertices[vertex]);
    return copies_[vertex].back();
  }

  std::vector<Vec2> points;
  std::vector<Vec2> paper;

 private:
  const AssignedPattern& creases_;
  const FlatMap& map_;
  double reach_;
  std::vector<std::vector<std::uint32_t>> copies_;
};

/// An edge as one of its facets has it.
FoldEdge seenFrom(const FoldEdge& edge, FacetId facet, VertexCopies& copies) {
  FoldEdge out = edge;
  out.from = copies.of(edge.from, facet);
  out.to = copies.of(edge.to, facet);
  return out;
}

}  // namespace

FoldedVertices foldedVerticesOf(const AssignedPattern& creases, const FlatMap& map,
                                const FacetLoops& loops) {
  VertexCopies copies(creases, map);
  FoldedVertices out;
  for (std::size_t f = 0; f < loops.faces.size(); ++f) {
    std::vector<std::uint32_t>& face = out.faces.emplace_back();
    for (const std::uint32_t v : loops.faces[f]) face.push_back(copies.of(v, FacetId(f)));
  }
  for (const FoldEdge& edge : loops.edges) {
    const FacetId first = edge.left.isValid() ? edge.left : edge.right;
    if (!first.isValid()) {
      out.edges.push_back(edge);
      continue;
    }
    FoldEdge one = seenFrom(edge, first, copies);
    if (edge.left.isValid() && edge.right.isValid()) {
      const FoldEdge other = seenFrom(edge, edge.right, copies);
      const bool isApart = other.from != one.from || other.to != one.to;
      if (isApart && edge.source.isValid() &&
          creases.pattern[edge.source].kind != EdgeKind::Hinge) {
        one.isSplit = true;
        one.right = FacetId();
        FoldEdge second = other;
        second.isSplit = true;
        second.left = FacetId();
        out.edges.push_back(one);
        out.edges.push_back(second);
        continue;
      }
    }
    out.edges.push_back(one);
  }
  out.isSplit = copies.points.size() > creases.pattern.vertices.size();
  out.points = std::move(copies.points);
  out.paper = std::move(copies.paper);
  if (!out.isSplit) {
    out.faces = loops.faces;
    out.edges = loops.edges;
  }
  return out;
}

}  // namespace kiri
