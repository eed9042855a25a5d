// Puts regions of planes into a mesh, triangle by triangle.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/rigid.h"
#include "core/geometry/tolerance.h"
#include "render/mesh/paper_mesh.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// One side of a plane, and what of it belongs to one facet.
struct MeshSide {
  ViewFrame frame;  ///< looks straight at the side
  Vec3 point;       ///< of the plane
  FacetId facet;
  Rigid pose;  ///< of the facet
  bool showsFront = true;
};

using Points = std::vector<Vec2>;

class MeshBuilder {
 public:
  MeshBuilder(PaperMesh& mesh, const Tolerance& tolerance);

  /// Adds what the loops bound, coordinates of side.frame: outer ones counter-clockwise, holes
  /// clockwise, closed without repeating the first point. Outer loops do not overlap.
  void addPaper(const MeshSide& side, const std::vector<Points>& loops);

  /// Adds the chain of points as segments. `first` says what they have in common; its ends and
  /// `along` are overwritten. Returns the number of the first of them.
  std::size_t addLine(const MeshSide& side, const Points& points, MeshSegment first,
                      std::vector<MeshSegment>& out) const;

  /// Less light along the chain, on the paper to its left.
  void addShades(const MeshSide& side, const Points& points);
  /// Less light on the paper on both sides of those hinges among the lines that are valleys.
  void addValleys(const std::vector<MeshSegment>& lines);

  /// Points of two planes that are the same but for rounding become the same floats.
  std::array<float, 3> rounded(Vec3 place) const;

 private:
  std::array<float, 3> placeOf(const MeshSide& side, Vec2 p) const;
  void addRegion(const MeshSide& side, const Points& border,
                 const std::vector<const Points*>& holes);
  void addConvex(const MeshSide& side, const Points& points);

  PaperMesh& mesh_;
  Tolerance tolerance_;
  double grain_;  ///< mm
};

std::array<float, 3> floats(Vec3 v);
Vec3 asVec(const std::array<float, 3>& v);

}  // namespace kiri
