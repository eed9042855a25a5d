// The faces into which lines divide the plane.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/creases/line_map.h"

namespace kiri {

/// Half-line 2i runs along line i in its direction, 2i + 1 against it; a face lies on the left of
/// its half-lines.
struct MapFaces {
  /// Loops of half-lines: the outer one of the face counter-clockwise, then those around what lies
  /// inside, clockwise. Face 0 is the unbounded one; it has no outer loop.
  std::vector<std::vector<std::vector<std::uint32_t>>> loops;
  std::vector<std::uint32_t> faceOf;  ///< by half-line

  std::size_t count() const { return loops.size(); }
  std::uint32_t left(std::size_t line) const { return faceOf[2 * line]; }
  std::uint32_t right(std::size_t line) const { return faceOf[2 * line + 1]; }
};

/// Faces in the order of their lowest half-line. Lines meet at their ends only and no two join the
/// same points. All decisions are exact for the stored doubles.
MapFaces facesOf(const LineMap& map);

}  // namespace kiri
