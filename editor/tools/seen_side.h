// From what the eye sees to what steps mean: they count from the front of the model.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/model/step.h"
#include "editor/view/pane_map.h"

namespace kiri {

/// Which way the plane of a facet points to the eye of a pane: its unit normal on that side, model
/// frame. On the sheet pane the eye sees the front or the back of the paper itself.
Vec3 seenUp(const FoldedState& state, const PaneMap& map, const Spot& spot);

/// True when the eye is on the side that the valleys and the left hand of steps refer to (upOf in
/// core/fold/fold.h).
bool seesAsSteps(const FoldedState& state, const PaneMap& map, const Spot& spot);

/// A valley seen from the other side is a mountain.
FoldType turnedIf(FoldType type, bool isTurned);

/// How high a facet lies in its plane as the eye counts; larger is nearer to the eye.
double seenHeight(const FoldedState& state, FacetId facet, Vec3 up);

}  // namespace kiri
