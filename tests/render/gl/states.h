// States to draw: random ones and those of the examples; pictures kept when a test fails.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/paper/folded_state.h"
#include "render/scene/image.h"
#include "tests/support/random_steps.h"

namespace kiri::test {

/// Ten random steps, and some of what lies flat opened then, so that most states stand in space.
FoldedState randomFolded(Random& random);

struct Example {
  std::string name;
  std::vector<FoldedState> states;  ///< folded halfway through the steps, and at the end
};
std::vector<Example> allExamples();

/// Writes a PNG into the folder that KIRI_FAILED_PICTURES names; nothing when it is not set.
void keepPicture(const Image& image, const std::string& name);

}  // namespace kiri::test
