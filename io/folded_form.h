// The mesh of a state as it lies folded: where paper is torn, its two sides have vertices of their
// own. SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"
#include "io/facet_mesh.h"

namespace kiri {

struct FoldedForm {
  std::vector<Vec3> vertices;   ///< model frame, mm
  std::vector<Vec2> paper;      ///< the same vertices at rest, paper frame, mm
  std::vector<MeshFace> faces;  ///< same order as in the mesh
  /// Torn and cut sides are borders here, one for each side that has paper; only a slit that is
  /// closed at both ends stays a cut.
  std::vector<MeshEdge> edges;
};

/// Requires the mesh of the state's own pattern.
FoldedForm foldedFormOf(const FoldedState& state, const FacetMesh& mesh);

}  // namespace kiri
