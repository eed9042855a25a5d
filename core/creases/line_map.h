// Lines between numbered points: what a drawing is while it is repaired.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/vec.h"
#include "core/creases/crease_drawing.h"

namespace kiri {

/// A straight line between two points of a LineMap.
struct MapLine {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Assignment assignment = Assignment::Unassigned;
  std::optional<double> angle;
  std::uint32_t drawn = kNotDrawn;  ///< number of the drawn line that it is a piece of

  static constexpr std::uint32_t kNotDrawn = 0xFFFFFFFF;
};

/// Units of the drawing, paper frame. Points that no line uses are allowed.
struct LineMap {
  std::vector<Vec2> points;
  std::vector<MapLine> lines;

  Vec2 from(const MapLine& line) const { return points[line.from]; }
  Vec2 to(const MapLine& line) const { return points[line.to]; }
};

/// The distances that a repair works with, units of the drawing.
struct RepairScale {
  double size = 0;    ///< diagonal of the box of all lines
  double same = 0;    ///< what rounding explains: not worth telling
  double within = 0;  ///< points nearer than this are one
};

}  // namespace kiri
