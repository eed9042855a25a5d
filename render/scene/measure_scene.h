// A leaf with its measures drawn in.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf/leaf_measures.h"
#include "core/paper/folded_state.h"
#include "render/scene/pattern_scene.h"

namespace kiri {

/// The unfolded paper, the axis from petiole to apex, length and width, and a ray to each lobe and
/// sinus with its angle and length; creases pale, teeth thin. Labels that find no place are left
/// out, those of lobes last. Groups: those of patternScene, then sinuses, lobes, axis, numbers.
/// `options.margin` is widened to hold the numbers.
Scene measureScene(const FoldedState& state, const LeafMeasures& measures,
                   const Appearance& appearance, PatternSceneOptions options = {});

}  // namespace kiri
