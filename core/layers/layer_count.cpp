// How many layers of paper lie on each other: a vertical line sweeps over each plane.
// SPDX-License-Identifier: MIT
#include "core/layers/layer_count.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/geometry/cubic.h"

namespace kiri {

namespace {

/// A straight piece of the border of a facet, in the plane; `left.x` < `right.x`.
struct Side {
  Vec2 left;
  Vec2 right;
  std::uint32_t facet = 0;

  double at(double x) const {
    return left.y + (right.y - left.y) * ((x - left.x) / (right.x - left.x));
  }
};

/// From one place where sides begin or end to the next.
struct Slab {
  double from = 0;
  double to = 0;
};

class LayerScan {
 public:
  /// `eps`: what is narrower does not count.
  LayerScan(std::vector<Side> sides, double eps) : sides_(std::move(sides)), eps_(eps) {
    std::sort(sides_.begin(), sides_.end(),
              [](const Side& a, const Side& b) { return a.left.x < b.left.x; });
  }

  std::uint32_t deepest() {
    std::vector<double> places;
    for (const Side& side : sides_) {
      places.push_back(side.left.x);
      places.push_back(side.right.x);
    }
    std::sort(places.begin(), places.end());
    std::uint32_t most = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Slab slab{places[i], places[i + 1]};
      if (slab.to - slab.from <= 2 * eps_) continue;
      for (; next < sides_.size() && sides_[next].left.x <= slab.from; ++next)
        met_.push_back(sides_[next]);
      std::erase_if(met_, [&](const Side& side) { return side.right.x < slab.to; });
      most = std::max(most, deepestIn(slab));
    }
    return most;
  }

 private:
  /// Between the crossings of its sides the depths along the line stay the same.
  std::uint32_t deepestIn(const Slab& slab) {
    std::vector<double> places = crossingsIn(slab);
    places.push_back(slab.from);
    places.push_back(slab.to);
    std::sort(places.begin(), places.end());
    std::uint32_t most = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (places[i + 1] - places[i] <= 2 * eps_) continue;
      most = std::max(most, deepestAt((places[i] + places[i + 1]) / 2));
    }
    return most;
  }

  /// Where sides cross: those that stand in another order on the right than on the left. Sides that
  /// lie on each other but for rounding do not cross.
  std::vector<double> crossingsIn(const Slab& slab) const {
    std::vector<std::pair<double, double>> heights;
    for (const Side& side : met_) heights.push_back({side.at(slab.from), side.at(slab.to)});
    std::sort(heights.begin(), heights.end());
    std::vector<double> crossings;
    for (std::size_t i = 1; i < heights.size(); ++i) {
      for (std::size_t j = i; j > 0; --j) {
        const double left = heights[j].first - heights[j - 1].first;
        const double right = heights[j - 1].second - heights[j].second;
        if (right <= eps_) break;
        if (left > eps_)
          crossings.push_back(slab.from + (slab.to - slab.from) * (left / (left + right)));
        std::swap(heights[j - 1], heights[j]);
      }
    }
    return crossings;
  }

  /// How many facets share a stretch of the line: each covers every other stretch between its
  /// sides.
  std::uint32_t deepestAt(double x) const {
    std::vector<std::pair<std::uint32_t, double>> met;
    for (const Side& side : met_) met.push_back({side.facet, side.at(x)});
    std::sort(met.begin(), met.end());
    std::vector<std::pair<double, int>> ends;
    for (std::size_t i = 0; i + 1 < met.size(); i += 2) {
      const double low = met[i].second + eps_;
      const double high = met[i + 1].second - eps_;
      if (low >= high) continue;
      ends.push_back({low, 1});
      ends.push_back({high, -1});
    }
    std::sort(ends.begin(), ends.end());
    std::uint32_t depth = 0;
    std::uint32_t most = 0;
    for (const auto& [height, change] : ends) {
      depth = change > 0 ? depth + 1 : depth - 1;
      most = std::max(most, depth);
    }
    return most;
  }

  std::vector<Side> sides_;
  std::vector<Side> met_;  ///< those that reach from one end of the slab to the other
  double eps_;
};

/// The sides of a facet as it lies in the plane; those that stand upright meet no upright line.
void addSides(const FoldedState& state, FacetId facet, const Rigid& plane,
              std::vector<Side>& sides) {
  const Rigid& pose = state.poseOf(facet);
  for (const EdgeUse use : state.pattern[facet].border) {
    // Along the edge's own direction, so that both of its facets get the same points.
    const Arc arc = arcOf(state.pattern, use.edge);
    const std::vector<double> steps = flatteningParameters(arc, state.tolerance().flattening());
    Vec2 last;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Vec2 here = plane.pullBack(pose.apply(pointAt(arc, steps[i])));
      if (i > 0 && here.x < last.x) sides.push_back({here, last, facet.index});
      if (i > 0 && here.x > last.x) sides.push_back({last, here, facet.index});
      last = here;
    }
  }
}

}  // namespace

std::uint32_t maxLayerCount(const FoldedState& state) {
  std::uint32_t deepest = 0;
  for (const LayerSet& set : state.layers.sets()) {
    const Rigid& plane = state.poseOf(set.upward.front());
    std::vector<Side> sides;
    for (const FacetId facet : set.upward) addSides(state, facet, plane, sides);
    deepest = std::max(deepest, LayerScan(std::move(sides), state.tolerance().match()).deepest());
  }
  return deepest;
}

}  // namespace kiri
