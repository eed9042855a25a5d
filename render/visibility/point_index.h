// Makes one point of points that lie nearly together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// Points of which no two are nearer than `eps`; the first to come stays where it is.
class PointIndex {
 public:
  explicit PointIndex(double eps) : eps_(eps) {}

  /// The number of the point within eps of `p`; `p` is added when there is none.
  std::uint32_t insert(Vec2 p);
  const std::vector<Vec2>& points() const { return points_; }
  std::vector<Vec2> take() { return std::move(points_); }
  void reserve(std::size_t count);

 private:
  double eps_;
  std::vector<Vec2> points_;
  std::vector<std::uint32_t> nextInCell_;
  std::unordered_map<std::uint64_t, std::uint32_t> cells_;  ///< looked up, never walked
};

}  // namespace kiri
