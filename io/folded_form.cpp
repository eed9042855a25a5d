// The mesh of a state as it lies folded: where paper is torn, its two sides have vertices of their
// own. SPDX-License-Identifier: MIT
#include "io/folded_form.h"

#include <algorithm>
#include <cstdint>

#include "core/base/disjoint_sets.h"

namespace kiri {

namespace {

/// Corners of faces, united into vertices where hinges and joins hold them together.
class Corners {
 public:
  explicit Corners(const FacetMesh& mesh) : mesh_(mesh) {
    std::size_t count = 0;
    for (const MeshFace& face : mesh.faces) {
      first_.push_back(static_cast<std::uint32_t>(count));
      count += face.vertices.size();
    }
    united_ = DisjointSets(count);
    for (const MeshEdge& edge : mesh.edges) {
      if (edge.kind != MeshEdgeKind::Hinge && edge.kind != MeshEdgeKind::Join) continue;
      united_.join(cornerOf(edge.left, edge.from), cornerOf(edge.right, edge.from));
      united_.join(cornerOf(edge.left, edge.to), cornerOf(edge.right, edge.to));
    }
  }

  /// The corner that stands for all that are united with this one: the lowest of them.
  std::uint32_t rootOf(std::uint32_t corner) { return united_.find(corner); }

  std::uint32_t rootAt(std::uint32_t face, std::uint32_t vertex) {
    return rootOf(cornerOf(face, vertex));
  }
  std::uint32_t firstOf(std::uint32_t face) const { return first_[face]; }
  std::size_t count() const { return united_.count(); }

 private:
  std::uint32_t cornerOf(std::uint32_t face, std::uint32_t vertex) const {
    const std::vector<std::uint32_t>& loop = mesh_.faces[face].vertices;
    const auto at = std::find(loop.begin(), loop.end(), vertex);
    return first_[face] + static_cast<std::uint32_t>(at - loop.begin());
  }

  const FacetMesh& mesh_;
  std::vector<std::uint32_t> first_;
  DisjointSets united_{0};
};

/// The edge as it borders one face, with the face on its left.
MeshEdge sideOf(const MeshEdge& edge, bool isLeft) {
  MeshEdge out = edge;
  out.kind = MeshEdgeKind::Border;
  if (!isLeft) {
    out.left = edge.right;
    std::swap(out.from, out.to);
  }
  out.right = MeshEdge::kNoFace;
  return out;
}

}  // namespace

FoldedForm foldedFormOf(const FoldedState& state, const FacetMesh& mesh) {
  Corners corners(mesh);
  FoldedForm out;
  out.faces = mesh.faces;
  std::vector<std::uint32_t> vertexOfRoot(corners.count(), MeshEdge::kNoFace);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const MeshFace& face = mesh.faces[f];
    for (std::uint32_t i = 0; i < face.vertices.size(); ++i) {
      std::uint32_t& vertex = vertexOfRoot[corners.rootOf(corners.firstOf(f) + i)];
      if (vertex == MeshEdge::kNoFace) {
        vertex = static_cast<std::uint32_t>(out.vertices.size());
        const Vec2 paper = mesh.vertices[face.vertices[i]];
        out.vertices.push_back(state.poseOf(face.facet).apply(paper));
        out.paper.push_back(paper);
      }
      out.faces[f].vertices[i] = vertex;
    }
  }
  const auto moved = [&](MeshEdge edge) {
    const std::uint32_t face = edge.left;
    edge.from = vertexOfRoot[corners.rootAt(face, edge.from)];
    edge.to = vertexOfRoot[corners.rootAt(face, edge.to)];
    return edge;
  };
  for (const MeshEdge& edge : mesh.edges) {
    if (edge.kind != MeshEdgeKind::Cut) {
      out.edges.push_back(moved(edge));
      continue;
    }
    const MeshEdge left = moved(sideOf(edge, true));
    const MeshEdge right = moved(sideOf(edge, false));
    if (left.from == right.to && left.to == right.from) {
      MeshEdge slit = left;
      slit.kind = MeshEdgeKind::Cut;
      slit.right = right.left;
      out.edges.push_back(slit);
    } else {
      out.edges.push_back(left);
      out.edges.push_back(right);
    }
  }
  return out;
}

}  // namespace kiri
