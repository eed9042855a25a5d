// SPDX-License-Identifier: MIT
#include "core/layers/refine.h"

#include <algorithm>

namespace kiri {

LayerOrder refined(const LayerOrder& order, const std::vector<FacetId>& origin) {
  std::uint32_t oldCount = 0;
  for (const FacetId old : origin) oldCount = std::max(oldCount, old.index + 1);
  std::vector<std::vector<FacetId>> successors(oldCount);
  for (std::size_t i = 0; i < origin.size(); ++i) successors[origin[i].index].push_back(FacetId(i));
  const auto after = [&](FacetId old) -> const std::vector<FacetId>& {
    static const std::vector<FacetId> kNobody;
    return old.index < successors.size() ? successors[old.index] : kNobody;
  };
  std::vector<LayerSet> sets;
  for (const LayerSet& set : order.sets()) {
    LayerSet next{set.normal, {}, {}};
    for (const FacetId old : set.upward) {
      next.upward.insert(next.upward.end(), after(old).begin(), after(old).end());
    }
    for (const auto& [upper, lower] : set.exceptions) {
      for (const FacetId a : after(upper)) {
        for (const FacetId b : after(lower)) next.exceptions.insert({a, b});
      }
    }
    if (!next.upward.empty()) sets.push_back(std::move(next));
  }
  return LayerOrder(std::move(sets));
}

}  // namespace kiri
