// Points that lie so near to each other that one is meant.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// Points joined when they lie within a distance of each other, one after the other.
struct Clusters {
  std::vector<std::uint32_t> of;  ///< cluster of each point; numbered by their first points
  std::vector<Vec2> middles;      ///< by cluster: the mean of its points
};
Clusters clustersOf(const std::vector<Vec2>& points, double within);

}  // namespace kiri
