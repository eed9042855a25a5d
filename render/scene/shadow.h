// The soft shadow that a model casts on the table.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/paper/folded_state.h"
#include "render/scene/scene.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// The points, model frame, where the corners of the borders (of curves: the control points) cast
/// their shadows. All of the shadow lies in their hull.
std::vector<Vec3> shadowPoints(const FoldedState& state);

/// The shadow on a table just below the model, under a lamp with some width at the upper left: many
/// fills on each other, hardly darkening each, one for each point of the lamp. The edge of the
/// shadow is the softer the higher the paper stands. Each fill is the exact silhouette seen from
/// there. Empty when the eye is not above the table. In perspective all of it must lie before the
/// eye. Errors: Cancelled.
Result<Group> shadowGroup(const FoldedState& state, const ViewFrame& view,
                          const Affine& viewToScene, const Progress& progress = {});

}  // namespace kiri
