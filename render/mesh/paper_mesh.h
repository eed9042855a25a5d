// The folded model as triangles and lines for a renderer with a depth buffer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/base/vec.h"
#include "core/paper/folded_state.h"
#include "render/scene/line_looks.h"

namespace kiri {

/// A corner of a triangle. Positions in the model frame, mm, relative to PaperMesh::origin.
struct MeshVertex {
  std::array<float, 3> position;
  std::array<float, 3> normal;  ///< of the side that is seen, unit
  std::array<float, 2> paper;   ///< paper frame, mm: for textures and grids
  std::uint32_t facet = 0;
  std::uint32_t isFront = 1;  ///< the front of the paper is seen
};

/// What a line of the mesh is. Crease: a hinge that lies flat; Edge: border of visible paper.
enum class MeshLine : std::uint8_t { Border, Edge, Crease, Mountain, Valley, Tear };

struct MeshSegment {
  std::array<float, 3> from;
  std::array<float, 3> to;
  std::array<float, 3> normal;  ///< of the side it is drawn on
  MeshLine kind = MeshLine::Edge;
  std::uint32_t facet = 0;
};

/// Visible parts of each plane from both sides (planeRegions): the triangles of a side wind
/// counter-clockwise as that side is seen, so a renderer that culls back faces and tests depth
/// shows exactly what is seen, from every direction, without bias between layers. Neighbouring
/// parts share their vertices: no cracks.
struct PaperMesh {
  Vec3 origin;
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> triangles;  ///< three indices each
  std::vector<MeshSegment> segments;
  std::uint32_t facetCount = 0;
};

PaperMesh meshOf(const FoldedState& state, const Progress& progress = {});
/// The flat sheet with the same facet numbers, z = 0, front up and back down.
PaperMesh sheetMeshOf(const FoldedState& state);

}  // namespace kiri
