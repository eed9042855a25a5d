// Random paper, and random eyes that look at it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/paper/folded_state.h"
#include "editor/view/camera.h"
#include "tests/support/random_steps.h"

namespace kiri::test {

/// Paper after up to a dozen random steps.
FoldedState randomState(std::uint64_t seed);

/// Fitted, then orbited, panned and zoomed; every other one in perspective.
Camera randomCamera(Random& random, const FoldedState& state);

/// Looks straight at the front, fitted into width x height pixels.
Camera frontCamera(const FoldedState& state, double width = 800, double height = 600);
Camera backCamera(const FoldedState& state, double width = 800, double height = 600);

/// The flat sheet, fitted.
SheetCamera sheetCamera(const FoldedState& state, bool showsBack = false);

/// A place of the paper as it appears in the pane; the facet is the one that holds it.
Vec2 pixelsOf(const FoldedState& state, const PaneMap& map, Vec2 paper);

}  // namespace kiri::test
