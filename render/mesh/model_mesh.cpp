// The mesh of a folded state.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "render/mesh/flattened.h"
#include "render/mesh/hinge_breaks.h"
#include "render/mesh/hinge_lines.h"
#include "render/mesh/mesh_builder.h"
#include "render/mesh/paper_mesh.h"
#include "render/visibility/plane_regions.h"
#include "render/visibility/slits.h"

namespace kiri {
namespace {

/// The middle of the box of all corners of the paper.
Vec3 middleOf(const FoldedState& state) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec3 low{kFar, kFar, kFar};
  Vec3 high = -low;
  for (std::uint32_t f = 0; f < state.pattern.facets.size(); ++f) {
    for (const EdgeUse use : state.pattern.facets[f].border) {
      const Vec3 p = state.poses[f].apply(state.pattern[startOf(state.pattern, use)]);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return low.x <= high.x ? (low + high) / 2 : Vec3{};
}

class ModelMesh {
 public:
  ModelMesh(const FoldedState& state, const std::vector<PlaneRegions>& planes)
      : state_(state),
        breaks_(state, planes),
        hinges_(state, breaks_),
        builder_(mesh_, state.tolerance()),
        chordError_(meshChordError(state.tolerance())) {
    mesh_.origin = middleOf(state);
    mesh_.facetCount = static_cast<std::uint32_t>(state.pattern.facets.size());
  }

  void add(const PlaneRegions& plane) {
    addSide(plane, plane.above, plane.fromAbove);
    addSide(plane, plane.below, plane.fromBelow);
  }

  PaperMesh finished() {
    hinges_.settle(edges_);
    mesh_.segments = std::move(creases_);
    mesh_.segments.insert(mesh_.segments.end(), edges_.begin(), edges_.end());
    builder_.addValleys(mesh_.segments);
    return std::move(mesh_);
  }

 private:
  using Ends = std::array<double, 4>;

  static Ends endsOf(Vec2 a, Vec2 b) { return {a.x, a.y, b.x, b.y}; }

  void addSide(const PlaneRegions& plane, const ViewFrame& frame, const VisibleRegions& regions) {
    collectSeams(regions);
    for (const VisibleFacet& part : regions.facets) {
      const MeshSide side{frame, plane.point, part.facet, state_.poseOf(part.facet),
                          part.showsFront};
      std::vector<Points> loops;
      for (const auto& loop : part.loops) {
        Points& points = loops.emplace_back();
        for (const BoundaryPiece& piece : loop) {
          const Points line = flattened(piece.arc, breaksOf(piece), chordError_);
          points.insert(points.end(), line.begin(), line.end() - 1);
          addLine(side, piece, line);
        }
      }
      builder_.addPaper(side, loops);
      addSlits(side, part);
    }
  }

  std::vector<double> ownBreaks(const BoundaryPiece& piece) const {
    if (!piece.edge.isValid() || !isFoldedHinge(state_.pattern[piece.edge])) return {};
    return breaks_.within(piece.edge, piece.from, piece.to);
  }

  /// Two facets of one plane may meet along hinges of both of them; each is divided like the other.
  void collectSeams(const VisibleRegions& regions) {
    seams_.clear();
    for (const VisibleFacet& part : regions.facets) {
      for (const auto& loop : part.loops) {
        for (const BoundaryPiece& piece : loop) {
          if (piece.isSilhouette()) continue;
          std::vector<double> breaks = ownBreaks(piece);
          if (breaks.empty()) continue;
          std::reverse(breaks.begin(), breaks.end());
          for (double& t : breaks) t = 1 - t;
          seams_.emplace(endsOf(piece.arc.end, piece.arc.start), std::move(breaks));
        }
      }
    }
  }

  std::vector<double> breaksOf(const BoundaryPiece& piece) const {
    std::vector<double> breaks = ownBreaks(piece);
    if (seams_.empty() || piece.isSilhouette()) return breaks;
    const auto others = seams_.equal_range(endsOf(piece.arc.start, piece.arc.end));
    if (others.first == others.second) return breaks;
    for (auto it = others.first; it != others.second; ++it) {
      breaks.insert(breaks.end(), it->second.begin(), it->second.end());
    }
    std::sort(breaks.begin(), breaks.end());
    const auto isSame = [](double a, double b) { return b - a <= kParallel; };
    breaks.erase(std::unique(breaks.begin(), breaks.end(), isSame), breaks.end());
    return breaks;
  }

  /// A seam between two parts is drawn once. So is a hinge of which both facets are seen.
  void addLine(const MeshSide& side, const BoundaryPiece& piece, const Points& points) {
    if (liesUnder(side.facet, piece)) builder_.addShades(side, points);
    const bool isHinge = hinges_.isOwn(side.facet, piece);
    if (isHinge && !piece.isSilhouette()) hinges_.notePaper(side, piece);
    if (!piece.isSilhouette() && piece.beyond < side.facet) return;
    MeshSegment segment;
    segment.normal = floats(side.frame.toEye);
    segment.facet = segment.otherFacet = side.facet.index;
    segment.kind = kindOf(side.facet, piece);
    if (!piece.isSilhouette()) {
      segment.otherNormal = segment.normal;
      segment.otherFacet = piece.beyond.index;
    }
    const bool isCrease = segment.kind == MeshLine::Crease;
    if (piece.isSilhouette() && isHinge) {
      hinges_.add(side, piece, points, segment, builder_, edges_);
    } else {
      builder_.addLine(side, points, segment, isCrease ? creases_ : edges_);
    }
  }

  void addSlits(const MeshSide& side, const VisibleFacet& part) {
    for (const SlitPiece& piece : visibleSlits(state_, part, side.frame)) {
      MeshSegment segment;
      segment.normal = segment.otherNormal = floats(side.frame.toEye);
      segment.facet = segment.otherFacet = side.facet.index;
      segment.kind = MeshLine::Border;
      builder_.addLine(side, flattened(piece.arc, {}, chordError_), segment, edges_);
    }
  }

  /// The paper goes on under the facet whose border this is.
  static bool liesUnder(FacetId facet, const BoundaryPiece& piece) {
    return !piece.isSilhouette() && piece.edge.isValid() && piece.facet == piece.beyond &&
           piece.facet != facet;
  }

  MeshLine kindOf(FacetId facet, const BoundaryPiece& piece) const {
    if (!piece.edge.isValid()) return MeshLine::Edge;
    const Edge& edge = state_.pattern[piece.edge];
    if (edge.kind != EdgeKind::Hinge) return MeshLine::Border;
    const bool joins = !piece.isSilhouette() && across(edge, facet) == piece.beyond;
    return joins && !isFoldedHinge(edge) ? MeshLine::Crease : MeshLine::Edge;
  }

  const FoldedState& state_;
  HingeBreaks breaks_;
  HingeLines hinges_;
  PaperMesh mesh_;
  MeshBuilder builder_;
  double chordError_;
  std::multimap<Ends, std::vector<double>> seams_;
  std::vector<MeshSegment> creases_;
  std::vector<MeshSegment> edges_;
};

}  // namespace

PaperMesh meshOf(const FoldedState& state, const Progress& progress) {
  const auto& sets = state.layers.sets();
  std::vector<PlaneRegions> planes;
  planes.reserve(sets.size());
  for (std::uint32_t set = 0; set < sets.size(); ++set) {
    if (!goesOn(progress, static_cast<double>(set) / static_cast<double>(sets.size()))) return {};
    if (!sets[set].upward.empty()) planes.push_back(planeRegionsOf(state, set));
  }
  ModelMesh mesh(state, planes);
  for (const PlaneRegions& plane : planes) {
    if (!goesOn(progress, 1)) return {};
    mesh.add(plane);
  }
  return mesh.finished();
}

}  // namespace kiri
