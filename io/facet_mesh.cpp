// The facets of a state as polygons that share vertices, as exchange formats want them.
// SPDX-License-Identifier: MIT
#include "io/facet_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/check.h"
#include "core/geometry/flattened_parts.h"
#include "core/geometry/region.h"

namespace kiri {

namespace {

/// Points by the cell of a square grid that holds them, for finding near ones. Ordered, so that
/// results are the same on every run.
class PointGrid {
 public:
  explicit PointGrid(double cell) : cell_(cell) {}

  void add(Vec2 p, std::uint32_t index) { cells_[keyOf(p.x, p.y)].push_back(index); }

  template <class Visit>
  void visit(Vec2 low, Vec2 high, const Visit& see) const {
    const Key a = keyOf(low.x, low.y);
    const Key b = keyOf(high.x, high.y);
    for (std::int64_t x = a.first; x <= b.first; ++x) {
      for (auto at = cells_.lower_bound({x, a.second});
           at != cells_.end() && at->first <= Key{x, b.second}; ++at) {
        for (const std::uint32_t index : at->second) see(index);
      }
    }
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;
  Key keyOf(double x, double y) const {
    return {static_cast<std::int64_t>(std::floor(x / cell_)),
            static_cast<std::int64_t>(std::floor(y / cell_))};
  }

  double cell_;
  std::map<Key, std::vector<std::uint32_t>> cells_;
};

class MeshBuilder {
 public:
  MeshBuilder(const CreasePattern& pattern, double chordError)
      : pattern_(pattern),
        chordError_(chordError),
        near_(4 * pattern.tolerance.length()),
        grid_(cellFor(pattern)) {}

  FacetMesh build() {
    for (std::size_t f = 0; f < pattern_.facets.size(); ++f) addFacet(FacetId(f));
    for (MeshFace& face : mesh_.faces) splitSides(face);
    makeEdges();
    return std::move(mesh_);
  }

 private:
  static double cellFor(const CreasePattern& pattern) {
    const double count = static_cast<double>(pattern.vertices.size() + 1);
    return pattern.tolerance.sheetSize() / std::sqrt(count);
  }

  std::uint32_t vertexAt(Vec2 p) {
    std::uint32_t found = MeshEdge::kNoFace;
    grid_.visit({p.x - near_, p.y - near_}, {p.x + near_, p.y + near_}, [&](std::uint32_t index) {
      if (distance(mesh_.vertices[index], p) <= near_) found = std::min(found, index);
    });
    if (found != MeshEdge::kNoFace) return found;
    const auto index = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(p);
    grid_.add(p, index);
    return index;
  }

  void addFacet(FacetId facet) {
    const std::vector<EdgeUse>& border = pattern_[facet].border;
    for (const EdgeUse& use : border) {
      if (pattern_[use.edge].isCurved()) mesh_.hasCurves = true;
    }
    const std::vector<ConvexPart> parts =
        convexPartsWithin(regionOf(pattern_, facet), pattern_.tolerance, chordError_);
    if (parts.size() > 1) mesh_.hasJoins = true;
    for (const ConvexPart& part : parts) {
      MeshFace face;
      face.facet = facet;
      for (std::size_t i = 0; i < part.points.size(); ++i) {
        const std::int32_t tag = part.tags[i];
        face.vertices.push_back(vertexAt(part.points[i]));
        face.sources.push_back(
            tag == ConvexPart::kInner ? EdgeId{} : border[static_cast<std::size_t>(tag)].edge);
      }
      dropRepeats(face);
      if (face.vertices.size() >= 3) mesh_.faces.push_back(std::move(face));
    }
  }

  /// Sides shorter than the distance within which vertices are one.
  static void dropRepeats(MeshFace& face) {
    MeshFace kept;
    const std::size_t n = face.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (face.vertices[i] == face.vertices[(i + 1) % n]) continue;
      kept.vertices.push_back(face.vertices[i]);
      kept.sources.push_back(face.sources[i]);
    }
    face.vertices = std::move(kept.vertices);
    face.sources = std::move(kept.sources);
  }

  /// Vertices that lie on the inside of a side become corners of the face, so that neighbours share
  /// whole sides.
  void splitSides(MeshFace& face) const {
    MeshFace split;
    const std::size_t n = face.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t from = face.vertices[i];
      split.vertices.push_back(from);
      split.sources.push_back(face.sources[i]);
      for (const std::uint32_t on : verticesOn(from, face.vertices[(i + 1) % n])) {
        split.vertices.push_back(on);
        split.sources.push_back(face.sources[i]);
      }
    }
    face.vertices = std::move(split.vertices);
    face.sources = std::move(split.sources);
  }

  std::vector<std::uint32_t> verticesOn(std::uint32_t from, std::uint32_t to) const {
    const Vec2 a = mesh_.vertices[from];
    const Vec2 b = mesh_.vertices[to];
    const double size = distance(a, b);
    const Vec2 along = (b - a) / size;
    std::vector<std::pair<double, std::uint32_t>> found;
    const Vec2 low{std::min(a.x, b.x) - near_, std::min(a.y, b.y) - near_};
    const Vec2 high{std::max(a.x, b.x) + near_, std::max(a.y, b.y) + near_};
    grid_.visit(low, high, [&](std::uint32_t index) {
      if (index == from || index == to) return;
      const Vec2 p = mesh_.vertices[index] - a;
      const double at = dot(p, along);
      if (at > 0 && at < size && std::fabs(cross(along, p)) <= near_) found.emplace_back(at, index);
    });
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> out;
    for (const auto& [at, index] : found) out.push_back(index);
    return out;
  }

  MeshEdgeKind kindOf(const MeshEdge& first, EdgeId source, FacetId facet) const {
    const bool isSameFacet = mesh_.faces[first.left].facet == facet;
    if (!first.source.isValid() && !source.isValid() && isSameFacet) return MeshEdgeKind::Join;
    if (first.source == source && source.isValid() && pattern_[source].kind == EdgeKind::Hinge) {
      return MeshEdgeKind::Hinge;
    }
    return MeshEdgeKind::Cut;
  }

  /// Pairs the sides of faces: a side and its reverse are one edge.
  void makeEdges() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open;
    for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
      const MeshFace& face = mesh_.faces[f];
      const std::size_t n = face.vertices.size();
      for (std::size_t i = 0; i < n; ++i) {
        const std::uint32_t from = face.vertices[i];
        const std::uint32_t to = face.vertices[(i + 1) % n];
        const auto partner = open.find({to, from});
        if (partner != open.end()) {
          MeshEdge& edge = mesh_.edges[partner->second];
          edge.kind = kindOf(edge, face.sources[i], face.facet);
          edge.right = f;
          open.erase(partner);
          continue;
        }
        open[{from, to}] = static_cast<std::uint32_t>(mesh_.edges.size());
        mesh_.edges.push_back(
            {from, to, f, MeshEdge::kNoFace, MeshEdgeKind::Border, face.sources[i]});
      }
    }
  }

  const CreasePattern& pattern_;
  double chordError_;
  double near_;
  PointGrid grid_;
  FacetMesh mesh_;
};

}  // namespace

FacetMesh meshOf(const CreasePattern& pattern, double chordError) {
  const double error = chordError > 0 ? chordError : pattern.tolerance.flattening();
  return MeshBuilder(pattern, error).build();
}

}  // namespace kiri
