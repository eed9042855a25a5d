// Vertices, edges and faces of one frame of a FOLD file, checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/creases/crease_drawing.h"
#include "io/patterns/fold_frames.h"

namespace kiri {

/// An edge between two vertices, by position.
struct FoldGraphEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Assignment assignment = Assignment::Unassigned;
  std::optional<double> angle;
};

/// The arrays of a frame. Every index is good, every used vertex has a place.
struct FoldGraph {
  std::vector<Vec3> vertices;
  std::vector<FoldGraphEdge> edges;
  /// Runs of vertices, in the order of the file; empty when the frame has none that can be used.
  std::vector<std::vector<std::uint32_t>> faces;
  bool isAssigned = true;  ///< the file has assignments or angles
  double size = 0;         ///< diagonal of the box around the used vertices
};

/// What the frame holds. Parts that make no sense are left out and counted in `notes`. Errors:
/// BadFile, without the name of the file - no vertices, no edges.
Result<FoldGraph> foldGraphOf(const FoldFrameView& frame, std::vector<std::string>& notes);

/// True when all vertices lie in one plane z = constant.
bool isLevel(const FoldGraph& graph);

/// The doubled area of a face, seen along z; positive when it runs counter-clockwise.
double doubledArea(const FoldGraph& graph, const std::vector<std::uint32_t>& face);

}  // namespace kiri
