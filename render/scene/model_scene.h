// A picture of the folded model.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/paper/folded_state.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"
#include "render/visibility/view_frame.h"

namespace kiri {

struct ModelSceneOptions {
  double margin = 5;  ///< mm around the model
  double scale = 1;   ///< 1: true size
  std::string title;
};

/// The model as it is seen from the direction of `view`: visible parts in the colours of their
/// sides, their borders, and creases that lie flat again.
Scene modelScene(const FoldedState& state, const Appearance& appearance, const ViewFrame& view,
                 const ModelSceneOptions& options = {});

}  // namespace kiri
