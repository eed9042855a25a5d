// The laws of flat-folded vertices, from the geometry alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

struct VertexLaws {
  int vertexCount = 0;              ///< vertices that were looked at and have folded creases
  std::vector<std::string> faults;  ///< sentences
};

/// Kawasaki (alternate angles add up to 180 degrees, within 1e-6) and Maekawa (mountains and
/// valleys differ by two) at every vertex of a flat state that has hinges only: inside the paper,
/// touched by no tear and no cut. Written apart from core/flatfold.
VertexLaws vertexLawsOf(const FoldedState& state);

}  // namespace kiri::test
