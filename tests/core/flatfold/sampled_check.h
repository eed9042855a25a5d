// A judge of flat states with thousands of facets: looks at many places instead of all.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

struct SampledCheck {
  std::size_t places = 0;               ///< places looked at
  std::size_t skipped = 0;              ///< places too near to other folds to tell sides apart
  std::vector<std::string> violations;  ///< the first few
};

/// Takes `perHinge` places on every hinge of a flat state and reads the layers just left and right
/// of it: they must have an order without rings, and along that order folds must close like
/// brackets, with no paper that goes on between the two sides of a fold or passing other paper.
/// `blur`, a part of the sheet: folds nearer to each other are one. Written apart from the search:
/// knows neither pairs nor stacks.
SampledCheck sampledCheck(const FoldedState& state, std::size_t perHinge, double blur);

}  // namespace kiri::test
