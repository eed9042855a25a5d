// Order problems made from first principles: maps, strips, and random ones.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

#include "core/flatfold/order_problem.h"

namespace kiri::test {

/// "upper lies above lower", in either order of the two.
Literal aboveOf(const OrderProblem& problem, std::size_t upper, std::size_t lower);

/// A map of rows x columns unit squares, all creases folded, no direction given. All facets lie on
/// one square; creases that fold to the same side of it must not cross.
OrderProblem mapProblem(std::size_t rows, std::size_t columns);

/// Up to `facets` facets with random overlaps, stacks, ties and known orders, and at most `pairs`
/// pairs. Most have states, some have none.
OrderProblem randomProblem(std::mt19937& random, std::size_t facets, std::size_t pairs);

/// All states by trying every choice of orders: bit p is the truth of pair p, ascending. Requires
/// few pairs. Written apart from the search.
std::vector<std::uint32_t> allStates(const OrderProblem& problem);

}  // namespace kiri::test
