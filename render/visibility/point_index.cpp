// Makes one point of points that lie nearly together.
// SPDX-License-Identifier: MIT
#include "render/visibility/point_index.h"

#include <cmath>
#include <limits>

namespace kiri {
namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

std::int64_t cellOf(double x, double size) {
  return static_cast<std::int64_t>(std::floor(x / size));
}

/// Different cells may get the same key: their points are then only looked at in vain.
std::uint64_t keyOf(std::int64_t x, std::int64_t y) {
  std::uint64_t key = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL;
  key ^= key >> 29;
  key += static_cast<std::uint64_t>(y) * 0xBF58476D1CE4E5B9ULL;
  return key ^ (key >> 32);
}

}  // namespace

void PointIndex::reserve(std::size_t count) {
  points_.reserve(count);
  nextInCell_.reserve(count);
  cells_.reserve(count);
}

std::uint32_t PointIndex::insert(Vec2 p) {
  const double size = 4 * eps_;
  const std::int64_t x0 = cellOf(p.x - eps_, size);
  const std::int64_t x1 = cellOf(p.x + eps_, size);
  const std::int64_t y0 = cellOf(p.y - eps_, size);
  const std::int64_t y1 = cellOf(p.y + eps_, size);
  std::uint32_t best = kNoPoint;
  double bestDistance = eps_;
  for (std::int64_t y = y0; y <= y1; ++y) {
    for (std::int64_t x = x0; x <= x1; ++x) {
      const auto it = cells_.find(keyOf(x, y));
      for (std::uint32_t i = it == cells_.end() ? kNoPoint : it->second; i != kNoPoint;
           i = nextInCell_[i]) {
        const double d = distance(points_[i], p);
        if (d < bestDistance || (d == bestDistance && best != kNoPoint && i < best)) {
          best = i;
          bestDistance = d;
        }
      }
    }
  }
  if (best != kNoPoint) return best;
  const auto number = static_cast<std::uint32_t>(points_.size());
  const auto [it, isNew] = cells_.try_emplace(keyOf(cellOf(p.x, size), cellOf(p.y, size)), number);
  nextInCell_.push_back(isNew ? kNoPoint : it->second);
  it->second = number;
  points_.push_back(p);
  return number;
}

}  // namespace kiri
