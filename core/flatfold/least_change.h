// Moving vertices as little as possible until equations hold.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatfold/flat_closing.h"

namespace kiri {

/// Where a vertex may go: nowhere, along a line, anywhere in the plane.
struct VertexFreedom {
  int directions = 0;
  Vec2 along{1, 0};  ///< unit; the second direction is perpendicular to it
};

using RowsAt = std::function<std::vector<ClosingRow>(const std::vector<Vec2>&)>;

/// The places nearest to `places` (least sum of squares, to first order) where all rows hold as
/// nearly as doubles let them. `farthestMove`: the longest step of a vertex that is tried at once.
/// Errors: Cancelled. Whether the rows hold in the end is for the caller to look at.
Result<std::vector<Vec2>> leastChange(std::vector<Vec2> places,
                                      const std::vector<VertexFreedom>& freedoms,
                                      const RowsAt& rowsAt, double farthestMove,
                                      const Progress& progress);

}  // namespace kiri
