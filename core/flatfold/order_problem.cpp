// Looking up pairs; sets of facets in one list.
// SPDX-License-Identifier: MIT
#include "core/flatfold/order_problem.h"

#include <algorithm>

#include "core/base/check.h"

namespace kiri {

void FacetSets::add(const std::vector<FacetId>& sorted) {
  facets_.insert(facets_.end(), sorted.begin(), sorted.end());
  starts_.push_back(facets_.size());
}

std::uint32_t OrderProblem::indexOf(FacetId a, FacetId b) const {
  auto first = pairs.begin();
  auto last = pairs.end();
  if (a.index + 1 < pairStarts.size()) {
    first = pairs.begin() + pairStarts[a.index];
    last = pairs.begin() + pairStarts[a.index + 1];
  }
  const auto at = std::lower_bound(first, last, FacetPair{a, b});
  if (at == last || *at != FacetPair{a, b}) return kNone;
  return static_cast<std::uint32_t>(at - pairs.begin());
}

Literal OrderProblem::above(FacetId x, FacetId y) const {
  const bool isTurned = y < x;
  const std::uint32_t pair = isTurned ? indexOf(y, x) : indexOf(x, y);
  KIRI_CHECK(pair != kNone, "only facets that overlap lie above each other");
  return {pair, isTurned};
}

void OrderProblem::indexPairs() {
  pairStarts.assign(facetCount + 1, 0);
  for (const FacetPair& pair : pairs) ++pairStarts[pair.a.index + 1];
  for (std::size_t f = 0; f < facetCount; ++f) pairStarts[f + 1] += pairStarts[f];
}

}  // namespace kiri
