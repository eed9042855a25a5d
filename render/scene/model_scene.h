// A picture of the folded model.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/paper/folded_state.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"
#include "render/scene/view_spec.h"
#include "render/visibility/view_frame.h"

namespace kiri {

struct ModelSceneOptions {
  double margin = 5;  ///< mm around the model
  double scale = 1;   ///< 1: true size
  std::string title;
  /// What the page shows, view coordinates, mm: pictures with the same box, scale and margin have
  /// the same size and the paper at the same place. None: the box of what is drawn.
  std::optional<Box> box = {};
  /// What a view in perspective looks at, for views by ViewSpec. None: the model itself; pictures
  /// that shall share an eye (a film) share a ball.
  std::optional<Sphere> sphere = {};
  Progress progress = {};  ///< for views by ViewSpec: asked now and then whether to go on
};

/// The model as it is seen from the direction of `view`: visible parts in the colours of their
/// sides, their borders, and creases that lie flat again.
Scene modelScene(const FoldedState& state, const Appearance& appearance, const ViewFrame& view,
                 const ModelSceneOptions& options = {});

/// The same with all that a ViewSpec can ask for. Errors: those of checkViewSpec; BadValue - an eye
/// inside the model, for `options.sphere` does not hold it; Cancelled.
Result<Scene> modelScene(const FoldedState& state, const Appearance& appearance,
                         const ViewSpec& spec, const ModelSceneOptions& options = {});

/// The box that the page of such a picture shows when none is given, view coordinates, mm; for
/// ModelSceneOptions::box. `options.box` is not looked at. Errors: those of checkViewSpec.
Result<Box> pictureBox(const FoldedState& state, const ViewSpec& spec,
                       const ModelSceneOptions& options = {});

}  // namespace kiri
