// How many layers of paper lie on each other.
// SPDX-License-Identifier: MIT
#include "core/layers/layer_count.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/geometry/bounds.h"
#include "core/geometry/convex.h"
#include "core/geometry/region.h"

namespace kiri {

namespace {

using Polygon = std::vector<Vec2>;

/// A convex place of the plane that `depth` facets cover.
struct Cell {
  Polygon polygon;
  std::uint32_t depth = 0;
};

/// The cells of one plane, by the squares of a grid that their boxes touch.
class CellMap {
 public:
  CellMap(double square, double eps) : square_(square), eps_(eps) {}

  std::uint32_t deepest() const { return deepest_; }

  /// Lays one convex polygon on top: what it covers of a cell becomes a deeper cell, the rest of it
  /// a new one.
  void lay(const Polygon& polygon) {
    std::vector<Polygon> bare = {polygon};
    for (const std::size_t index : touching(polygon)) {
      const Polygon covered = intersection(cells_[index].polygon, polygon, eps_);
      if (covered.empty()) continue;
      const Cell old = cells_[index];
      std::vector<Polygon> rest;
      for (const Polygon& part : bare) cutAway(part, old.polygon, rest);
      bare = std::move(rest);
      std::vector<Polygon> uncovered;
      cutAway(old.polygon, polygon, uncovered);
      if (uncovered.empty()) {
        cells_[index].depth = old.depth + 1;
      } else {
        remove(index);
        for (Polygon& part : uncovered) add({std::move(part), old.depth});
        add({covered, old.depth + 1});
      }
      deepest_ = std::max(deepest_, old.depth + 1);
    }
    for (Polygon& part : bare) add({std::move(part), 1});
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;

  /// Appends what is left of `polygon` outside `hole`, as convex parts.
  void cutAway(const Polygon& polygon, const Polygon& hole, std::vector<Polygon>& out) const {
    Polygon inside = polygon;
    std::vector<Polygon> parts;
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const Vec2 a = hole[i];
      const Vec2 b = hole[(i + 1) % hole.size()];
      Polygon outside = clipLeft(inside, b, a, eps_);
      if (!outside.empty()) parts.push_back(std::move(outside));
      inside = clipLeft(inside, a, b, eps_);
      if (inside.empty()) {
        out.push_back(polygon);
        return;
      }
    }
    for (Polygon& part : parts) out.push_back(std::move(part));
  }

  template <class Visit>
  void forSquares(const Polygon& polygon, const Visit& visit) const {
    const Box box = boundsOf(polygon);
    const auto square = [this](double v) {
      return static_cast<std::int64_t>(std::floor(v / square_));
    };
    for (std::int64_t x = square(box.low.x); x <= square(box.high.x); ++x) {
      for (std::int64_t y = square(box.low.y); y <= square(box.high.y); ++y) visit(Key{x, y});
    }
  }

  std::vector<std::size_t> touching(const Polygon& polygon) const {
    std::vector<std::size_t> out;
    forSquares(polygon, [&](Key key) {
      const auto at = squares_.find(key);
      if (at != squares_.end()) out.insert(out.end(), at->second.begin(), at->second.end());
    });
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  void add(Cell cell) {
    deepest_ = std::max(deepest_, cell.depth);
    const std::size_t index = cells_.size();
    forSquares(cell.polygon, [&](Key key) { squares_[key].push_back(index); });
    cells_.push_back(std::move(cell));
  }

  void remove(std::size_t index) {
    forSquares(cells_[index].polygon, [&](Key key) {
      std::vector<std::size_t>& list = squares_[key];
      list.erase(std::remove(list.begin(), list.end(), index), list.end());
    });
    cells_[index].polygon.clear();
  }

  double square_;
  double eps_;
  std::vector<Cell> cells_;
  std::map<Key, std::vector<std::size_t>> squares_;
  std::uint32_t deepest_ = 0;
};

std::uint32_t deepestOf(const FoldedState& state, const LayerSet& set) {
  if (set.upward.size() < 2) return static_cast<std::uint32_t>(set.upward.size());
  const Rigid& plane = state.poseOf(set.upward.front());
  std::vector<Polygon> polygons;
  Box all{{0, 0}, {0, 0}};
  for (const FacetId facet : set.upward) {
    for (const ConvexPart& part : convexParts(regionOf(state.pattern, facet), state.tolerance())) {
      Polygon polygon;
      for (const Vec2 p : part.points)
        polygon.push_back(plane.pullBack(state.poseOf(facet).apply(p)));
      if (signedArea(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
      const Box box = boundsOf(polygon);
      all = polygons.empty() ? box : joined(all, box);
      polygons.push_back(std::move(polygon));
    }
  }
  const double width = std::max(all.high.x - all.low.x, all.high.y - all.low.y);
  CellMap cells(width / std::sqrt(static_cast<double>(polygons.size())), state.tolerance().match());
  for (const Polygon& polygon : polygons) cells.lay(polygon);
  return cells.deepest();
}

}  // namespace

std::uint32_t maxLayerCount(const FoldedState& state) {
  std::uint32_t deepest = 0;
  for (const LayerSet& set : state.layers.sets())
    deepest = std::max(deepest, deepestOf(state, set));
  return deepest;
}

}  // namespace kiri
