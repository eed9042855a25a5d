// The folded model as triangles and lines for a renderer with a depth buffer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/base/vec.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// A corner of a triangle. Positions in the model frame, mm, relative to PaperMesh::origin.
struct MeshVertex {
  std::array<float, 3> position;
  std::array<float, 3> normal;  ///< of the side that is seen, unit
  float height = 0;  ///< of the plane above the origin, along the normal; equal all over the side
  std::array<float, 2> paper;  ///< paper frame, mm: for textures and grids
  std::uint32_t facet = 0;
  std::uint32_t isFront = 1;  ///< the front of the paper is seen
};

/// What a line of the mesh is. Border: rim of the sheet, cuts, and tears of the model (those of the
/// sheet are Tear). Edge: a folded hinge, and where
/// layers end over others for any other reason. Crease: a hinge that lies flat. Mountain, Valley:
/// hinges on the sheet, as the side that is seen shows them; of a hinge that lies flat now, what
/// its fold line makes of it.
enum class MeshLine : std::uint8_t { Border, Edge, Crease, Mountain, Valley, Tear };
inline constexpr std::size_t kMeshLines = 6;

/// A straight piece of a line. It runs with the paper that it bounds on its left, as seen from the
/// side that `normal` points to; the paper on its right is that of `otherNormal`.
struct MeshSegment {
  std::array<float, 3> from;
  std::array<float, 3> to;
  std::array<float, 3> normal;            ///< of the side it is drawn on
  std::array<float, 3> otherNormal = {};  ///< zero: there is no paper on the right
  float along = 0;                        ///< mm from where the line begins to `from`, for dashes
  std::uint32_t facet = 0;
  std::uint32_t otherFacet = 0;  ///< whose paper `otherNormal` belongs to
  MeshLine kind = MeshLine::Edge;
  bool isThin = false;        ///< on the sheet: a hinge that lies flat now
  bool isFromJoined = false;  ///< the line goes on before `from`, almost straight
  bool isToJoined = false;    ///< and behind `to`
  /// The paper of `otherNormal` is covered by layers of its plane, and the line with it: it is
  /// there only for who sees that plane from behind.
  bool isCovered = false;
};

/// Paper that gets less light along a straight piece of a line: at the bottom of a valley, and
/// beside a layer that lies on it. The paper is on the left, as seen from the side of `normal`.
struct MeshShade {
  std::array<float, 3> from;
  std::array<float, 3> to;
  std::array<float, 3> normal;
  float before = 0;    ///< mm of the same line before `from`
  float behind = 0;    ///< and behind `to`
  float strength = 1;  ///< 1: the most
  std::uint32_t facet = 0;
  bool isValley = false;  ///< the bottom of a valley
};

/// Visible parts of each plane from both sides (planeRegions): the triangles of a side wind
/// counter-clockwise as that side is seen, so a renderer that leaves out what turns its back and
/// tests depth shows exactly what is seen, from every direction, without bias between layers.
/// Neighbouring parts, and those on both sides of a hinge, share the points of their border: no
/// cracks. There are needles between points on a line; rounding may turn them over, so what turns
/// its back is told by `normal` and `height`, not by the winding.
struct PaperMesh {
  Vec3 origin;
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> triangles;  ///< three indices each
  std::vector<MeshSegment> segments;     ///< in the order in which they are drawn: creases first
  std::vector<MeshShade> shades;         ///< valleys last
  std::uint32_t facetCount = 0;
};

/// The mesh of a state. Empty when `progress` stops it. Where paper passes through paper, the depth
/// buffer shows the line in which it does.
PaperMesh meshOf(const FoldedState& state, const Progress& progress = {});
/// The flat sheet with the same facet numbers, z = 0, front up and back down.
PaperMesh sheetMeshOf(const FoldedState& state);

}  // namespace kiri
