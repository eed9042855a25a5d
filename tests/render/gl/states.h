// States to draw: random ones and those of the examples; pictures kept when a test fails.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
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
/// In the build with sanitizers every fifth.
std::vector<Example> allExamples();

/// A sheet with the folds of Miura in it, halfway open: n x n facets that hold together, each in a
/// plane of its own.
FoldedState miura(std::size_t n);

/// Writes a PNG into the folder that KIRI_FAILED_PICTURES names; nothing when it is not set.
void keepPicture(const Image& image, const std::string& name);

}  // namespace kiri::test
