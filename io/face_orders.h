// Which face lies over which, as FOLD says it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/paper/folded_state.h"
#include "io/facet_mesh.h"

namespace kiri {

/// Face `f` lies on the side of face `g` that the front of `g` is turned to (+1), or on the other
/// side (-1).
struct FaceOrder {
  std::uint32_t f = 0;
  std::uint32_t g = 0;
  int side = 1;
};

struct FaceOrders {
  std::vector<FaceOrder> list;  ///< f < g, sorted
  bool isReduced = false;       ///< pairs that follow from others were left out of large stacks
};

/// The order of all pairs of faces of different facets that overlap in one plane. `mesh` is that of
/// the state.
FaceOrders faceOrdersOf(const FoldedState& state, const FacetMesh& mesh);

}  // namespace kiri
