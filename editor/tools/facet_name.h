// A facet remembered by a place on its paper, for what outlives a state.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/paper/folded_state.h"

namespace kiri {

/// A facet as steps name it: by a point well inside. Finding it again is quick as long as the state
/// is the same.
class FacetName {
 public:
  FacetName(const FoldedState& state, FacetId facet)
      : place_(interiorPointOf(state.pattern, facet)), lastSeen_(facet) {}

  /// Paper frame, mm.
  Vec2 place() const { return place_; }
  /// None when there is no paper any more.
  std::optional<FacetId> in(const FoldedState& state) const;

 private:
  Vec2 place_;
  FacetId lastSeen_;
};

}  // namespace kiri
