// Which facet lies above which: one layer-set for each plane.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/base/vec.h"

namespace kiri {

/// The facets of one plane of the model. The relation is meant for pairs that overlap; for other
/// pairs it is only a listing. A stack is stored as a list; what no list can say (cyclic overlap,
/// thesis Fig 5.11) is stored as exceptions to it.
struct LayerSet {
  Vec3 normal;                  ///< unit normal of the plane, model frame; "up" for this set
  std::vector<FacetId> upward;  ///< bottom to top along `normal`
  std::set<std::pair<FacetId, FacetId>>
      exceptions;  ///< (upper, lower) pairs that the list has the wrong way round
};

/// The layer order of a whole state: every facet is in exactly one set.
class LayerOrder {
 public:
  LayerOrder() = default;
  explicit LayerOrder(std::vector<LayerSet> sets);

  const std::vector<LayerSet>& sets() const { return sets_; }
  /// Index into sets() of the plane that holds the facet.
  std::uint32_t setOf(FacetId facet) const { return places_[facet.index].set; }
  /// Place in the list of its set, 0 at the bottom.
  std::uint32_t rankOf(FacetId facet) const { return places_[facet.index].rank; }
  bool areCoplanar(FacetId a, FacetId b) const { return setOf(a) == setOf(b); }
  /// True when `a` is above `b` along the normal of their set. Requires two facets of one set.
  bool isAbove(FacetId a, FacetId b) const;

 private:
  struct Place {
    std::uint32_t set = 0;
    std::uint32_t rank = 0;
  };
  std::vector<LayerSet> sets_;
  std::vector<Place> places_;
};

}  // namespace kiri
