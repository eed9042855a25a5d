// Points are sorted into squares as wide as the distance; only neighbouring squares are compared.
// SPDX-License-Identifier: MIT
#include "core/flatfold/cluster.h"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.h"

namespace kiri {
namespace {

struct Placed {
  double column = 0;
  double row = 0;
  std::uint32_t point = 0;

  auto operator<=>(const Placed&) const = default;
};

/// Joins the point with those of the squares from (column, row) to (column, lastRow).
void joinNear(const std::vector<Placed>& placed, const Placed& self, Placed from, double lastRow,
              const std::vector<Vec2>& points, double within, DisjointSets& joined) {
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
  DisjointSets joined(points.size());
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
