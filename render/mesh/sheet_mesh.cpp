// The mesh of the sheet as it lies unfolded.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/mesh/flattened.h"
#include "render/mesh/hinge_breaks.h"
#include "render/mesh/mesh_builder.h"
#include "render/mesh/paper_mesh.h"

namespace kiri {
namespace {

Vec3 middleOf(const CreasePattern& pattern) {
  if (pattern.vertices.empty()) return {};
  Box box{pattern.vertices[0], pattern.vertices[0]};
  for (const Vec2 p : pattern.vertices) box = joined(box, {p, p});
  const Vec2 middle = (box.low + box.high) / 2;
  return {middle.x, middle.y, 0};
}

/// Mountain or valley as the front of the paper shows it.
MeshLine kindOf(const Edge& edge) {
  if (edge.kind == EdgeKind::Border || edge.kind == EdgeKind::Cut) return MeshLine::Border;
  if (edge.kind == EdgeKind::Tear) return MeshLine::Tear;
  if (isFoldedHinge(edge)) return edge.angle > 0 ? MeshLine::Valley : MeshLine::Mountain;
  if (!edge.line.isValid()) return MeshLine::Crease;
  return edge.sign > 0 ? MeshLine::Valley : MeshLine::Mountain;
}

/// What is a mountain from the front is a valley from the back.
MeshLine turnedOver(MeshLine kind) {
  if (kind == MeshLine::Mountain) return MeshLine::Valley;
  return kind == MeshLine::Valley ? MeshLine::Mountain : kind;
}

int rankOf(MeshLine kind) {
  if (kind == MeshLine::Crease) return 0;
  return kind == MeshLine::Mountain || kind == MeshLine::Valley ? 1 : 2;
}

class SheetMesh {
 public:
  explicit SheetMesh(const CreasePattern& pattern)
      : pattern_(pattern),
        builder_(mesh_, pattern.tolerance),
        chordError_(meshChordError(pattern.tolerance)) {
    mesh_.origin = middleOf(pattern);
    mesh_.facetCount = static_cast<std::uint32_t>(pattern.facets.size());
  }

  PaperMesh run() {
    for (std::uint32_t f = 0; f < mesh_.facetCount; ++f) {
      addPaper(FacetId(f), true);
      addPaper(FacetId(f), false);
    }
    for (int rank = 0; rank < 3; ++rank) {
      for (std::uint32_t e = 0; e < pattern_.edges.size(); ++e) addLine(EdgeId(e), rank);
    }
    return std::move(mesh_);
  }

 private:
  static MeshSide sideOf(FacetId facet, bool showsFront) {
    return {showsFront ? frontView() : backView(), {}, facet, {}, showsFront};
  }

  /// Coordinates of the paper in those of the view of a side.
  static Vec2 inView(Vec2 p, bool showsFront) { return {showsFront ? p.x : -p.x, p.y}; }

  void addPaper(FacetId facet, bool showsFront) {
    std::vector<Points> loops;
    for (const Loop& loop : regionOf(pattern_, facet).loops) {
      Points& points = loops.emplace_back();
      for (const Arc& arc : loop) {
        const Points line = flattened(arc, {}, chordError_);
        points.insert(points.end(), line.begin(), line.end() - 1);
      }
      for (Vec2& p : points) p = inView(p, showsFront);
      if (!showsFront) std::reverse(points.begin(), points.end());
    }
    builder_.addPaper(sideOf(facet, showsFront), loops);
  }

  void addLine(EdgeId id, int rank) {
    const Edge& edge = pattern_[id];
    const MeshLine kind = kindOf(edge);
    if (rankOf(kind) != rank || (!edge.left.isValid() && !edge.right.isValid())) return;
    Points points = flattened(arcOf(pattern_, id), {}, chordError_);
    MeshSegment segment;
    segment.isThin = edge.kind == EdgeKind::Hinge && !isFoldedHinge(edge);
    for (const bool showsFront : {true, false}) {
      // Paper on the left, as that side shows it.
      const bool hasLeft = showsFront ? edge.left.isValid() : edge.right.isValid();
      Points line = points;
      for (Vec2& p : line) p = inView(p, showsFront);
      const FacetId left = showsFront ? edge.left : edge.right;
      const FacetId right = showsFront ? edge.right : edge.left;
      if (!hasLeft) std::reverse(line.begin(), line.end());
      const MeshSide side = sideOf(hasLeft ? left : right, showsFront);
      segment.facet = side.facet.index;
      segment.otherFacet = left.isValid() && right.isValid() ? right.index : segment.facet;
      segment.kind = showsFront ? kind : turnedOver(kind);
      segment.normal = floats(side.frame.toEye);
      segment.otherNormal =
          left.isValid() && right.isValid() ? segment.normal : std::array<float, 3>{};
      builder_.addLine(side, line, segment, mesh_.segments);
    }
  }

  const CreasePattern& pattern_;
  PaperMesh mesh_;
  MeshBuilder builder_;
  double chordError_;
};

}  // namespace

PaperMesh sheetMeshOf(const FoldedState& state) { return SheetMesh(state.pattern).run(); }

}  // namespace kiri
