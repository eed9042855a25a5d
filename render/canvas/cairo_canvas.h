// Draws scenes with cairo.
// SPDX-License-Identifier: MIT
#pragma once

#include <cairo.h>

#include "render/scene/scene.h"

namespace kiri {

/// Draws the scene on a cairo context whose unit is the mm, y down from the upper left corner of
/// the page. `leastSeam`: mm; underlays of seams are made at least so wide, for pixels wider than
/// they are.
void drawScene(cairo_t* cr, const Scene& scene, double leastSeam);

}  // namespace kiri
