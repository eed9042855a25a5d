// What a tool sees of the world when something happens.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/paper/folded_state.h"
#include "editor/snap/snap.h"
#include "editor/tools/proposal.h"
#include "editor/view/pane_map.h"
#include "editor/view/selection.h"

namespace kiri {

/// References hold for one call only.
struct Scope {
  std::shared_ptr<const FoldedState> state;  ///< at the cursor of the history
  int number = 1;                            ///< of the step that would be made
  PaneMap model;
  PaneMap sheet;
  SnapSettings snaps;  ///< already off while the key that suspends them is held
  const Selection& selection;
  const Preview* preview = nullptr;  ///< the newest that is known; may be of an earlier proposal
  bool isLeaf = false;               ///< the model opens all at once

  const PaneMap& map(Pane pane) const { return pane == Pane::Model ? model : sheet; }
};

}  // namespace kiri
