// A wish of the hand: this paper on top of that.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// Which facet is to lie on top at a place of the folded model. Points inside facets, paper frame.
struct LayerWish {
  Vec2 upper;
  bool showsFront = true;   ///< the side of `upper` that is turned to the person
  std::vector<Vec2> lower;  ///< all others that lie there
};

}  // namespace kiri
