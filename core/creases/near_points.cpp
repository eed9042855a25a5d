// SPDX-License-Identifier: MIT
#include "core/creases/near_points.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

constexpr std::uint32_t kNoPoint = 0xFFFFFFFF;

/// The square of a coordinate; what is beyond all numbers is in the last one.
std::int64_t squareNumber(double squares) {
  constexpr double kLast = 4e18;
  return std::isnan(squares)
             ? 0
             : static_cast<std::int64_t>(std::clamp(std::floor(squares), -kLast, kLast));
}

}  // namespace

std::size_t NearPoints::Hash::operator()(const Square& s) const {
  // Multiplicative hashing with two odd constants of 64 random bits.
  const std::uint64_t x = static_cast<std::uint64_t>(s.x) * 0x9E3779B97F4A7C15U;
  const std::uint64_t y = static_cast<std::uint64_t>(s.y) * 0xC2B2AE3D27D4EB4FU;
  const std::uint64_t mixed = x ^ (y + (x >> 29U));
  return static_cast<std::size_t>(mixed ^ (mixed >> 32U));
}

NearPoints::Square NearPoints::squareOf(Vec2 p) const {
  return {squareNumber((p.x - origin_.x) / within_), squareNumber((p.y - origin_.y) / within_)};
}

std::optional<std::uint32_t> NearPoints::nearest(Vec2 p) const {
  const Square middle = squareOf(p);
  std::optional<std::uint32_t> best;
  double least = within_;
  for (std::int64_t dx = -1; dx <= 1; ++dx) {
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      const auto it = last_.find({middle.x + dx, middle.y + dy});
      if (it == last_.end()) continue;
      for (std::uint32_t i = it->second; i != kNoPoint; i = next_[i]) {
        const double d = distance(points_[i], p);
        const bool isBetter = best ? d < least || (d == least && i < *best) : d <= least;
        if (!isBetter) continue;
        best = i;
        least = d;
      }
    }
  }
  return best;
}

std::uint32_t NearPoints::add(Vec2 p) {
  const std::uint32_t index = static_cast<std::uint32_t>(points_.size());
  points_.push_back(p);
  const auto [it, isNew] = last_.try_emplace(squareOf(p), index);
  next_.push_back(isNew ? kNoPoint : it->second);
  it->second = index;
  return index;
}

}  // namespace kiri
