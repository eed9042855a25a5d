// Free places for labels on a page.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/cubic.h"

namespace kiri {

/// A place that was found for a label.
struct LabelPlace {
  Vec2 middle;
  Vec2 near;            ///< where its box is nearest to what it belongs to
  bool isAway = false;  ///< so far off that a line should lead to it
};

/// Keeps labels off a shape, off each other, and on the page. All in scene coordinates.
class LabelRoom {
 public:
  /// `shape`: borders as closed polylines with short sides; may be empty.
  explicit LabelRoom(const Box& page, std::vector<std::vector<Vec2>> shape = {})
      : loops_(std::move(shape)), page_(page) {}

  /// Nothing shall be written there.
  void keepFree(const Box& box) { taken_.push_back(box); }

  /// The first free place for a label of `size` beyond `from` in a direction (unit), not farther
  /// than `reach`, to which nothing bars the way; it is taken then. None where
  /// there is none.
  std::optional<LabelPlace> takeBeyond(Vec2 from, Vec2 direction, Vec2 size, double reach);

  /// The middle of a place for a label of `size` beside `point`, `away` mm from it or a little
  /// more: where it covers the least of what is taken, and on the page in any case. It is taken
  /// then. The shape is not looked at.
  Vec2 takeAround(Vec2 point, Vec2 size, double away);

 private:
  bool isFree(const Box& box) const;
  bool isOnShape(const Box& box) const;
  bool isClear(Vec2 from, Vec2 to) const;
  double covered(const Box& box) const;
  Box pushedIntoPage(const Box& box) const;

  std::vector<std::vector<Vec2>> loops_;
  std::vector<Box> taken_;
  Box page_;
};

}  // namespace kiri
