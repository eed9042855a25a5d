// Finds what lies near without looking at everything.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/cubic.h"

namespace kiri {

/// A regular grid of cells over a box. Each cell lists numbers in the order in which they were
/// added.
class Grid {
 public:
  /// `typicalSize`: size of the things to be added; `count`: how many there will be.
  Grid(const Box& box, Vec2 typicalSize, std::size_t count);

  /// Adds a thing to all cells that its box, or the straight segment from a to b, may touch.
  void addBox(const Box& box, std::uint32_t number);
  void addSegment(Vec2 a, Vec2 b, double margin, std::uint32_t number);

  const std::vector<std::uint32_t>& at(Vec2 p) const;
  /// Calls `visit(number)` for the entries of all cells that the box may touch; entries may come
  /// more than once.
  template <class Visit>
  void visit(const Box& box, const Visit& visit) const {
    const Range r = rangeOf(box);
    for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
      for (std::uint32_t x = r.x0; x <= r.x1; ++x) {
        for (const std::uint32_t number : cells_[std::size_t{y} * nx_ + x]) visit(number);
      }
    }
  }

 private:
  struct Range {
    std::uint32_t x0, x1, y0, y1;
  };
  std::uint32_t column(double x) const;
  std::uint32_t row(double y) const;
  Range rangeOf(const Box& box) const;

  Vec2 low_;
  Vec2 perMm_;
  std::uint32_t nx_ = 1;
  std::uint32_t ny_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

inline Box grown(const Box& box, double margin) {
  return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

/// True when the boxes share more than `margin` in both directions (a negative margin allows a
/// gap).
inline bool boxesMeet(const Box& a, const Box& b, double margin) {
  return a.low.x + margin <= b.high.x && b.low.x + margin <= a.high.x &&
         a.low.y + margin <= b.high.y && b.low.y + margin <= a.high.y;
}

}  // namespace kiri
