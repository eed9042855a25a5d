// The faces of a drawing, for a FOLD file.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/creases/crease_drawing.h"

namespace kiri {

/// A drawing as vertices and edges: ends that are equal to the last bit are one vertex.
struct VertexList {
  std::vector<Vec2> places;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< by line
};
VertexList verticesOf(const CreaseDrawing& drawing);

/// Faces as runs of vertices, counter-clockwise.
struct FaceList {
  std::vector<std::vector<std::uint32_t>> faces;
  std::string complaint;  ///< why there are none; empty when there are
};
/// The drawing's own faces where their sides are lines of it; else those of its planar map, when
/// that needs no repair.
FaceList facesOf(const CreaseDrawing& drawing, const VertexList& vertices);

/// [f, g, side], as FOLD has them.
struct FoldOrder {
  std::uint32_t f = 0;
  std::uint32_t g = 0;
  int side = 1;
};
/// The drawing's orders between those faces. `lost`: how many name no two of them.
std::vector<FoldOrder> ordersOf(const CreaseDrawing& drawing, const VertexList& vertices,
                                const FaceList& faces, std::size_t& lost);

}  // namespace kiri
