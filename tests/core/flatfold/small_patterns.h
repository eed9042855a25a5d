// Small random crease patterns, and all their layer orders by trying everything.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/creases/assigned_pattern.h"
#include "core/paper/folded_state.h"
#include "tests/support/random_steps.h"

namespace kiri::test {

/// A pattern of 2 to 8 facets: folded at random by the kernel, a single vertex, or a strip of
/// uneven widths; creases with directions, some of them wrong, or without. It may not fold flat.
AssignedPattern smallPattern(Random& random);

/// A pair of facets that overlap, found apart from the product, and whether the first is above.
struct OrderedPair {
  FacetId a;
  FacetId b;
  bool isAbove = false;
  bool operator==(const OrderedPair&) const = default;
};
using WholeOrder = std::vector<OrderedPair>;

/// All orders of the overlapping facets that the independent judge of layer orders accepts,
/// ascending as truth values from the first pair on. Rings over common ground and creases of known
/// direction are weeded out on the way, what is left is judged. None: more than `limit` to judge.
/// Requires a pattern that folds flat, in one piece, with `rest` at rest.
std::optional<std::vector<WholeOrder>> ordersByTrying(const AssignedPattern& creases, FacetId rest,
                                                      std::size_t limit);

}  // namespace kiri::test
