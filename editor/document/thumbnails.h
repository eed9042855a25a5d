// Small pictures of states for lists of steps and galleries.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/paper/folded_state.h"
#include "render/scene/image.h"

namespace kiri {

/// The state from the front in the model's colours, on a transparent ground, fitting into `pixels`
/// squared.
Result<Image> thumbnailOf(const FoldedState& state, const Model& model, int pixels,
                          const Progress& progress = {});

}  // namespace kiri
