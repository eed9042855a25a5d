// What both panes draw at this moment.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/paper/folded_state.h"
#include "editor/view/marks.h"

namespace kiri {

/// The paper to draw: the state at the cursor, or a preview, a slide, a moment of the film.
struct Shown {
  std::shared_ptr<const FoldedState> state;
  std::vector<FacetTint> tints;  ///< one for each facet of `state`, or empty
  std::uint64_t revision = 0;    ///< another number whenever `state` is another
  bool isPreview = false;        ///< not made yet
  /// The state at the cursor: what the Spots of marks belong to. Another than `state` during a
  /// preview, a slide or the film.
  std::shared_ptr<const FoldedState> base;
};

}  // namespace kiri
