// The shape of a flat model as it lies: outline, layers, colours.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// Holds when the convex hull of the paper as it lies has these corners, counter-clockwise from any
/// of them, within 1e-9 of the sheet.
testing::AssertionResult hasHull(const FoldedState& state, const std::vector<Vec2>& corners);

/// How many facets lie at a place of the model frame.
int layersAt(const FoldedState& state, Vec2 place);

/// What is seen from one side, mm^2 in the view.
struct SeenAreas {
  double front = 0;  ///< of the paper's front
  double back = 0;
};
SeenAreas seenFromFront(const FoldedState& state);
SeenAreas seenFromBack(const FoldedState& state);

/// A place of the sheet, and that a vertex of the pattern is there within 1e-9 of the sheet.
testing::AssertionResult hasVertex(const CreasePattern& pattern, Vec2 place);

}  // namespace kiri::test
