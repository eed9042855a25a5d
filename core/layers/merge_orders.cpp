// SPDX-License-Identifier: MIT
#include "core/layers/merge_orders.h"

#include <algorithm>
#include <map>

namespace kiri {

std::vector<AbovePair> relationsWithin(const LayerSet& set, PlaneView& view) {
  std::vector<AbovePair> pairs;
  for (std::size_t low = 0; low < set.upward.size(); ++low) {
    for (std::size_t high = low + 1; high < set.upward.size(); ++high) {
      const FacetId a = set.upward[low];
      const FacetId b = set.upward[high];
      if (!view.doOverlap(a, b)) continue;
      const bool isTurned = set.exceptions.count({a, b}) != 0;
      pairs.push_back(isTurned ? AbovePair{a, b} : AbovePair{b, a});
    }
  }
  return pairs;
}

LayerSet mergedOrder(const LayerSet& first, const LayerSet& second,
                     const std::vector<AbovePair>& pairs) {
  std::vector<FacetId> all = first.upward;
  all.insert(all.end(), second.upward.begin(), second.upward.end());
  std::map<FacetId, std::size_t> placeOf;
  for (std::size_t i = 0; i < all.size(); ++i) placeOf[all[i]] = i;
  std::vector<std::vector<std::size_t>> uppersOf(all.size());
  std::vector<std::size_t> lowersLeft(all.size(), 0);
  for (const AbovePair& pair : pairs) {
    uppersOf[placeOf[pair.lower]].push_back(placeOf[pair.upper]);
    ++lowersLeft[placeOf[pair.upper]];
  }
  // Take the first facet with nothing left beneath it; in a circle, the one with least.
  std::vector<bool> isTaken(all.size(), false);
  LayerSet result{first.normal, {}, {}};
  for (std::size_t taken = 0; taken < all.size(); ++taken) {
    std::size_t best = all.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!isTaken[i] && (best == all.size() || lowersLeft[i] < lowersLeft[best])) best = i;
    }
    isTaken[best] = true;
    result.upward.push_back(all[best]);
    for (const std::size_t upper : uppersOf[best]) {
      if (!isTaken[upper]) --lowersLeft[upper];
    }
  }
  std::map<FacetId, std::size_t> rank;
  for (std::size_t i = 0; i < result.upward.size(); ++i) rank[result.upward[i]] = i;
  for (const AbovePair& pair : pairs) {
    if (rank[pair.upper] < rank[pair.lower]) result.exceptions.insert({pair.upper, pair.lower});
  }
  return result;
}

}  // namespace kiri
