// How a pane's eye is told to the renderer.
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/desktop/look/display.h"
#include "editor/view/pane_map.h"
#include "render/gl/renderer.h"
#include "render/scene/view_spec.h"

namespace kiri::desktop {

/// The picture of what lies in `ball` as the map shows it, for a framebuffer with `ratio` pixels
/// for each pixel of the window, on the ground of the theme.
GlView cardViewOf(const PaneMap& map, const Sphere& ball, const Display& display, double ratio);

}  // namespace kiri::desktop
