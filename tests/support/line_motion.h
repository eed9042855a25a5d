// The motion by which a fold line is set to an angle: axis, degrees, and what moves.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/layers/relayer.h"
#include "core/paper/folded_state.h"

namespace kiri::test {

struct LineMotion {
  std::vector<bool> moves;
  Motion motion;
};

/// How the line named `line` gets from where it is to `amount`. Throws std::runtime_error when its
/// hinges are out of line or the paper is joined around them.
LineMotion motionTo(const FoldedState& state, const std::string& line, double amount);

}  // namespace kiri::test
