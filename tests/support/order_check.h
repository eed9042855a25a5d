// Brute-force check of a layer order: every pair, every triple, every hinge (guide: constraints of
// flat foldings). SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// What is wrong with the layer order, as sentences; empty when it is right. Checked are: every
/// facet stands in one set and its plane is the set's; overlapping facets of one plane are in one
/// set; the relation has no circle over common ground; paper does not pass through paper at any
/// hinge (decided locally, at sample points of the hinge just left and right of it); a valley has
/// the fronts of its facets facing each other. Cost grows with the cube of the facets: meant for up
/// to about 150.
std::vector<std::string> orderViolations(const FoldedState& state);

}  // namespace kiri::test
