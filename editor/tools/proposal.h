// What a tool offers to do, and what would come of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The step that a tool would make now.
struct Proposal {
  Step step;
  bool isComplete = true;  ///< Enter may make it; false: the hand is still drawing
};

/// What the step would do to the paper. Exactly one of `after` and `error` is there.
struct Preview {
  Step step;
  std::shared_ptr<const FoldedState> before;
  std::shared_ptr<const FoldedState> after;
  std::optional<Error> error;
  std::vector<Collision> collisions;  ///< those that the step adds
};

}  // namespace kiri
