// Giving back what cairo made.
// SPDX-License-Identifier: MIT
#include "render/canvas/cairo_handles.h"

namespace kiri {

void CairoDestroy::operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
void CairoDestroy::operator()(cairo_t* cr) const { cairo_destroy(cr); }

}  // namespace kiri
