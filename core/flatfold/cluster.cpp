// Points are sorted into squares as wide as the distance; only neighbouring squares are compared.
// SPDX-License-Identifier: MIT
#include "core/flatfold/cluster.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kiri {
namespace {

struct Placed {
  double column = 0;
  double row = 0;
  std::uint32_t point = 0;

  auto operator<=>(const Placed&) const = default;
};

class Joined {
 public:
  explicit Joined(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t a) {
    while (first_[a] != a) a = first_[a] = first_[first_[a]];
    return a;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    first_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> first_;
};

/// Joins the point with those of the squares from (column, row) to (column, lastRow).
void joinNear(const std::vector<Placed>& placed, const Placed& self, Placed from, double lastRow,
              const std::vector<Vec2>& points, double within, Joined& joined) {
  auto it = std::lower_bound(placed.begin(), placed.end(), from);
  for (; it != placed.end() && it->column == from.column && it->row <= lastRow; ++it) {
    if (joined.find(it->point) == joined.find(self.point)) continue;
    if (distance(points[it->point], points[self.point]) <= within)
      joined.join(it->point, self.point);
  }
}

}  // namespace

Clusters clustersOf(const std::vector<Vec2>& points, double within) {
  std::vector<Placed> placed;
  placed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    placed.push_back({std::floor(points[i].x / within), std::floor(points[i].y / within),
                      static_cast<std::uint32_t>(i)});
  std::sort(placed.begin(), placed.end());
  Joined joined(points.size());
  for (const Placed& p : placed) {
    joinNear(placed, p, {p.column, p.row, p.point}, p.row + 1, points, within, joined);
    joinNear(placed, p, {p.column + 1, p.row - 1, 0}, p.row + 1, points, within, joined);
  }
  Clusters clusters;
  clusters.of.resize(points.size());
  std::vector<double> counts;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t first = joined.find(i);
    if (first == i) {
      clusters.of[i] = static_cast<std::uint32_t>(clusters.middles.size());
      clusters.middles.push_back(points[i]);
      counts.push_back(1);
      continue;
    }
    // A mean that stays exact where all points are the same.
    const std::uint32_t cluster = clusters.of[i] = clusters.of[first];
    counts[cluster] += 1;
    Vec2& middle = clusters.middles[cluster];
    middle = middle + (points[i] - middle) / counts[cluster];
  }
  return clusters;
}

}  // namespace kiri
