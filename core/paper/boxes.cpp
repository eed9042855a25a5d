// SPDX-License-Identifier: MIT
#include "core/paper/boxes.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/arc_range.h"

namespace kiri {
namespace {

constexpr Range kNothing{HUGE_VAL, -HUGE_VAL};

/// Widens `range` to hold `offset` plus what the arc reaches along `direction`.
void widen(Range& range, const Arc& arc, Vec2 direction, double offset) {
  const Range reach = rangeAlong(arc, direction);
  range = {std::min(range.low, offset + reach.low), std::max(range.high, offset + reach.high)};
}

}  // namespace

ModelBox modelBoxOf(const FoldedState& state) {
  Range x = kNothing;
  Range y = kNothing;
  Range z = kNothing;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    const Rigid& pose = state.poses[f];
    for (const EdgeUse use : state.pattern.facets[f].border) {
      const Arc arc = arcOf(state.pattern, use);
      widen(x, arc, {pose.x.x, pose.y.x}, pose.origin.x);
      widen(y, arc, {pose.x.y, pose.y.y}, pose.origin.y);
      widen(z, arc, {pose.x.z, pose.y.z}, pose.origin.z);
    }
  }
  return {{x.low, y.low, z.low}, {x.high, y.high, z.high}};
}

Box paperBoxOf(const CreasePattern& pattern) {
  Range x = kNothing;
  Range y = kNothing;
  for (const Facet& facet : pattern.facets) {
    for (const EdgeUse use : facet.border) {
      const Arc arc = arcOf(pattern, use);
      widen(x, arc, {1, 0}, 0);
      widen(y, arc, {0, 1}, 0);
    }
  }
  return {{x.low, y.low}, {x.high, y.high}};
}

}  // namespace kiri
