// Free places for labels around a shape.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/cubic.h"

namespace kiri {

/// A place that was found for a label.
struct LabelPlace {
  Vec2 middle;
  Vec2 near;            ///< where its box is nearest to what it belongs to
  bool isAway = false;  ///< so far off that a line should lead to it
};

/// Keeps labels off the shape, off each other, and on the page. All in scene coordinates.
class LabelRoom {
 public:
  /// `loops`: the shape's borders as closed polylines with short sides.
  LabelRoom(std::vector<std::vector<Vec2>> loops, const Box& page)
      : loops_(std::move(loops)), page_(page) {}

  /// The first free place for a label of `size` beyond `from` in a direction (unit), not farther
  /// than `reach`; it is taken then. None where there is none.
  std::optional<LabelPlace> take(Vec2 from, Vec2 direction, Vec2 size, double reach);

 private:
  bool isFree(const Box& box) const;
  bool isOnShape(const Box& box) const;
  bool isClear(Vec2 from, Vec2 to) const;

  std::vector<std::vector<Vec2>> loops_;
  std::vector<Box> taken_;
  Box page_;
};

}  // namespace kiri
