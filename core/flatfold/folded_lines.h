// The edges of a flat folded pattern as lines of the folded plane.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/flatfold/flat_map.h"

namespace kiri {

/// One side of paper along a line, or both sides of a hinge. Left is that of the line's direction,
/// in the folded plane.
struct FoldedLine {
  EdgeId edge;
  FacetId first;
  FacetId second;  ///< of a hinge; else none
  bool firstIsLeft = false;
  bool secondIsLeft = false;

  bool isHinge() const { return second.isValid(); }
  bool isFold() const { return isHinge() && firstIsLeft == secondIsLeft; }
};

/// A vertex has as many points as there are fans of facets around it that hinges hold together.
struct FoldedLines {
  std::vector<Vec2> points;
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< by line, into points
  std::vector<FoldedLine> lines;
};
FoldedLines foldedLinesOf(const AssignedPattern& creases, const FlatMap& map);

}  // namespace kiri
