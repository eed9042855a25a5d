// The pixels of cairo's images, and the ground below them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cairo.h>

#include "render/scene/image.h"
#include "render/scene/scene.h"

namespace kiri {

/// The pixels of an image surface, colours not multiplied by their alpha. Requires the format RGB24
/// or ARGB32.
Image pixelsOf(cairo_surface_t* surface);

/// One colour everywhere: also where a page ends within a pixel.
void paintGround(cairo_t* cr, const Color& ground);

}  // namespace kiri
