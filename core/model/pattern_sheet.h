// The sheet and the step that a planar map of creases means.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/creases/assigned_pattern.h"
#include "core/model/model.h"

namespace kiri {

/// The outline of a pattern in one piece: a square or rectangle where its corners say so, else a
/// polygon with its holes. Vertices on straight sides are left to the step.
SheetSpec sheetOfOutline(const CreasePattern& pattern);

/// The creases and cuts, with the vertices that they use, all in their old order.
PatternStep stepOfCreases(const AssignedPattern& creases);

/// The largest connected piece of paper, by area; paper holds together across hinges, cuts and
/// tears here. `dropped`: how many pieces were left out.
struct LargestPiece {
  AssignedPattern creases;
  std::size_t dropped = 0;
};
LargestPiece largestPieceOf(const AssignedPattern& creases);

}  // namespace kiri
