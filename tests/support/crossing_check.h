// Brute-force check that no paper stands in other paper: facets of different planes.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// Pairs of facets whose insides pass through each other, as sentences; empty when none do. What
/// lies in one plane is the matter of orderViolations. Places less than 1e-6 of the sheet deep
/// count as touching (2e-3 where borders are curved, for they are taken as coarse polylines). Cost
/// grows with the square of the facets.
std::vector<std::string> crossingViolations(const FoldedState& state);

}  // namespace kiri::test
