// Lines and points of a map by neighbourhood: boxes that hold few lines each.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/line_map.h"

namespace kiri {

/// A half-open box of the plane: boxes of a tree hold each point of the plane once.
struct TreeBox {
  std::array<double, 2> low{-std::numeric_limits<double>::max(),
                            -std::numeric_limits<double>::max()};
  std::array<double, 2> high{std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::max()};

  bool holds(Vec2 p) const {
    return p.x >= low[0] && p.x < high[0] && p.y >= low[1] && p.y < high[1];
  }
};

/// A box that is not divided any more.
struct TreeLeaf {
  TreeBox box;
  std::vector<std::uint32_t> lines;   ///< that come into the box or near to it, ascending
  std::vector<std::uint32_t> points;  ///< in the box
  int depth = 0;
};

/// Divides the plane at medians until few lines are left in each box or dividing only copies them,
/// and shows all boxes in a fixed order until `visit` says no. A line is with every box from which
/// it is at most `margin` away. Errors: Cancelled.
Status visitLeaves(const LineMap& map, std::vector<std::uint32_t> points, double margin,
                   const std::function<bool(const TreeLeaf&)>& visit, const Progress& progress);

}  // namespace kiri
