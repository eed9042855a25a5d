// The examples' states, for tools that are to make the same by hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/model/replay.h"

namespace kiri::test {

/// A model of examples/ with all its states.
struct Example {
  Model model;
  Replay replay;

  /// After so many steps.
  const FoldedState& after(std::size_t steps) const;
  /// Step `number`, from 1.
  const Step& step(std::size_t number) const { return model.steps[number - 1]; }
};
/// Throws when there is no such file, or a step does not apply.
Example exampleOf(const std::string& name);

/// The largest distance, mm, from the rim of one paper to that of the other, both ways; on the
/// sheet.
double rimGap(const FoldedState& a, const FoldedState& b);

}  // namespace kiri::test
