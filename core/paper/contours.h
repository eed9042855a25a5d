// The contours of the paper: where it ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/crease_pattern.h"

namespace kiri {

/// Closed chains of border edges, each with the paper on its left: outer contours run
/// counter-clockwise, holes clockwise. Hinges, tears and cuts with paper on both sides are crossed.
/// Ordered by the lowest edge.
std::vector<std::vector<EdgeUse>> contoursOf(const CreasePattern& pattern);

}  // namespace kiri
