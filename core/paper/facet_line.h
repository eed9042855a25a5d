// A segment drawn on one facet, and the same segment on the facets that lie in its plane.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/paper/folded_state.h"

namespace kiri {

/// A directed segment in the paper frame of one facet; it may lie beyond the facet.
struct FacetLine {
  FacetId facet;
  Vec2 from;
  Vec2 to;
};

/// The line in the paper frame of another facet of the same plane.
FacetLine lineOn(const FoldedState& state, const FacetLine& line, FacetId facet);

}  // namespace kiri
