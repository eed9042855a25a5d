// Looking up which facet lies above which.
// SPDX-License-Identifier: MIT
#include "core/paper/layer_order.h"

#include <algorithm>

#include "core/base/check.h"

namespace kiri {

LayerOrder::LayerOrder(std::vector<LayerSet> sets) : sets_(std::move(sets)) {
  std::size_t count = 0;
  for (const LayerSet& set : sets_) {
    for (const FacetId f : set.upward) count = std::max<std::size_t>(count, f.index + 1);
  }
  places_.resize(count);
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    for (std::size_t r = 0; r < sets_[s].upward.size(); ++r) {
      places_[sets_[s].upward[r].index] = {static_cast<std::uint32_t>(s),
                                           static_cast<std::uint32_t>(r)};
    }
  }
}

bool LayerOrder::isAbove(FacetId a, FacetId b) const {
  KIRI_CHECK(areCoplanar(a, b), "layers are compared within one plane");
  const LayerSet& set = sets_[setOf(a)];
  if (!set.exceptions.empty()) {
    if (set.exceptions.count({a, b}) != 0) return true;
    if (set.exceptions.count({b, a}) != 0) return false;
  }
  return rankOf(a) > rankOf(b);
}

}  // namespace kiri
