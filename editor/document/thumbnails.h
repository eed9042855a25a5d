// Small pictures of states for lists of steps and galleries.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/paper/folded_state.h"
#include "render/scene/appearance.h"
#include "render/scene/image.h"
#include "render/scene/view_spec.h"

namespace kiri {

/// The state from the front in the model's colours, shaded, on a transparent ground, fitting into
/// `pixels` squared. For a screen of double density ask for twice the pixels: lines are then drawn
/// twice as wide. Textures are not read. Errors: BadValue - less than 1 or more than 16384 pixels;
/// Cancelled.
Result<Image> thumbnailOf(const FoldedState& state, const Model& model, int pixels,
                          const Progress& progress = {});

/// The same with an appearance, such as one with textures. `density`: pixels of the screen for one
/// of the toolkit; lines are so many pixels wide.
Result<Image> thumbnailOf(const FoldedState& state, Appearance appearance, int pixels,
                          double density = 1, const Progress& progress = {});

/// The same from another side, in the middle of the picture. Errors: those of checkViewSpec too.
Result<Image> thumbnailOf(const FoldedState& state, Appearance appearance, const ViewSpec& view,
                          int pixels, double density, const Progress& progress = {});

/// The unfolded sheet with its creases.
Result<Image> patternThumbnail(const FoldedState& state, Appearance appearance, int pixels,
                               double density = 1);

}  // namespace kiri
