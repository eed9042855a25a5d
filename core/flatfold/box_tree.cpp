// The tree lies in one array, each left child behind its parent.
// SPDX-License-Identifier: MIT
#include "core/flatfold/box_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kiri {
namespace {

constexpr std::uint32_t kLeaf = 6;

}  // namespace

Box boxOf(const Segment2& s) {
  return {{std::min(s.from.x, s.to.x), std::min(s.from.y, s.to.y)},
          {std::max(s.from.x, s.to.x), std::max(s.from.y, s.to.y)}};
}

double distanceTo(const Segment2& s, Vec2 p) {
  const Vec2 d = s.to - s.from;
  const double along = dot(p - s.from, d);
  const double square = dot(d, d);
  if (along <= 0) return distance(p, s.from);
  if (along >= square) return distance(p, s.to);
  return std::abs(cross(d, p - s.from)) / std::sqrt(square);
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), items_(boxes_.size()) {
  std::iota(items_.begin(), items_.end(), 0U);
  if (boxes_.empty()) return;
  nodes_.reserve(boxes_.size() / 2 + 4);
  build(0, static_cast<std::uint32_t>(boxes_.size()));
  std::vector<Box> sorted;
  sorted.reserve(boxes_.size());
  for (const std::uint32_t i : items_) sorted.push_back(boxes_[i]);
  boxes_ = std::move(sorted);
}

void BoxTree::build(std::uint32_t first, std::uint32_t last) {
  const std::size_t self = nodes_.size();
  Box box = boxes_[items_[first]];
  for (std::uint32_t i = first + 1; i < last; ++i) box = joined(box, boxes_[items_[i]]);
  nodes_.push_back({box, first, last, 0});
  if (last - first <= kLeaf) return;
  const bool isWide = box.high.x - box.low.x >= box.high.y - box.low.y;
  const auto middleOf = [&](std::uint32_t i) {
    const Box& b = boxes_[i];
    return isWide ? b.low.x + b.high.x : b.low.y + b.high.y;
  };
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(items_.begin() + first, items_.begin() + half, items_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double ma = middleOf(a);
                     const double mb = middleOf(b);
                     return ma != mb ? ma < mb : a < b;
                   });
  build(first, half);
  nodes_[self].right = static_cast<std::uint32_t>(nodes_.size());
  build(half, last);
}

BoxTree::Query::Query(const Segment2& segment, double reach)
    : box_(boxOf(segment)), from_(segment.from), normal_(perpendicular(segment.to - segment.from)) {
  box_.low = box_.low - Vec2{reach, reach};
  box_.high = box_.high + Vec2{reach, reach};
  // Rounding of long segments must not lose what touches them.
  reach_ = (reach + kVanishing * (length(segment.from) + length(segment.to))) * length(normal_);
}

}  // namespace kiri
