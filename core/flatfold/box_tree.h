// Finds among many boxes those that a line passes near.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/cubic.h"
#include "core/geometry/tolerance.h"

namespace kiri {

/// A straight line from one point to another.
struct Segment2 {
  Vec2 from;
  Vec2 to;
};

Box boxOf(const Segment2& segment);
/// Distance of a point from a segment.
double distanceTo(const Segment2& segment, Vec2 point);

/// A binary tree over boxes, halved along their longer extent. Visits in an order that depends on
/// the boxes only.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Calls `visit(index)` for every box that lies within `reach` of the segment, and perhaps a few
  /// that lie just outside.
  template <class Visit>
  void near(const Segment2& segment, double reach, Visit&& visit) const {
    if (nodes_.empty()) return;
    const Query query(segment, reach);
    std::uint32_t stack[kDepth];
    std::size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
      const Node& node = nodes_[stack[--height]];
      if (!query.reaches(node.box)) continue;
      if (node.right == 0) {
        for (std::uint32_t i = node.first; i < node.last; ++i) {
          if (query.reaches(boxes_[i])) visit(items_[i]);
        }
        continue;
      }
      stack[height++] = node.right;
      stack[height++] = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
    }
  }

 private:
  static constexpr std::size_t kDepth = 64;

  struct Node {
    Box box;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t right = 0;  ///< 0: a leaf; the left child follows its parent
  };

  /// A segment widened by a reach: separating axes are those of the box and the segment's normal.
  class Query {
   public:
    Query(const Segment2& segment, double reach);
    bool reaches(const Box& b) const {
      if (b.low.x > box_.high.x || b.high.x < box_.low.x || b.low.y > box_.high.y ||
          b.high.y < box_.low.y)
        return false;
      const Vec2 middle = (b.low + b.high) * 0.5 - from_;
      const Vec2 half = (b.high - b.low) * 0.5;
      const double width = std::abs(normal_.x) * half.x + std::abs(normal_.y) * half.y;
      return std::abs(dot(normal_, middle)) <= reach_ + width * (1 + kParallel);
    }

   private:
    Box box_;
    Vec2 from_;
    Vec2 normal_;   ///< not of unit length
    double reach_;  ///< times the length of the normal
  };

  void build(std::uint32_t first, std::uint32_t last);

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> items_;
  std::vector<Node> nodes_;
};

}  // namespace kiri
