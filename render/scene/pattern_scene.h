// A picture of the unfolded sheet with its crease pattern.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/paper/folded_state.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"

namespace kiri {

enum class PatternFill {
  Paper,  ///< the paper in the colour of its front
  None,   ///< lines only, as cutting and scoring machines want it
};

struct PatternSceneOptions {
  double margin = 5;  ///< mm around the sheet
  double scale = 1;   ///< 1: true size
  std::string title;
  PatternFill fill = PatternFill::Paper;
};

/// The sheet at rest, front towards the viewer, in the paper frame. Groups: print (paper), cut
/// (borders, tears), mountain, valley, flat. A hinge is a mountain or valley by the sign of its
/// angle; one that lies flat by the direction of the fold that made it, drawn thinner; an added
/// edge is flat.
Scene patternScene(const FoldedState& state, const Appearance& appearance,
                   const PatternSceneOptions& options = {});

/// Where the paper frame comes to lie in that picture.
Affine patternPlacement(const CreasePattern& pattern, const PatternSceneOptions& options);

}  // namespace kiri
