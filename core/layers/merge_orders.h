// A list that agrees with given relations as far as a list can, and the exceptions where it cannot.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/layers/plane_view.h"
#include "core/paper/layer_order.h"

namespace kiri {

struct AbovePair {
  FacetId upper;
  FacetId lower;
};

/// The relations of a set between facets that overlap.
std::vector<AbovePair> relationsWithin(const LayerSet& set, PlaneView& view);

/// The facets of both sets in one set (with the normal of the first): bottom to top as `pairs` ask;
/// pairs that go round in a circle (cyclic overlap) become exceptions. Facets without relations
/// stay in the order given.
LayerSet mergedOrder(const LayerSet& first, const LayerSet& second,
                     const std::vector<AbovePair>& pairs);

}  // namespace kiri
