// Owners of what cairo makes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cairo.h>

#include <memory>

namespace kiri {

struct CairoDestroy {
  void operator()(cairo_surface_t* surface) const;
  void operator()(cairo_t* cr) const;
};
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDestroy>;
using CairoContext = std::unique_ptr<cairo_t, CairoDestroy>;

}  // namespace kiri
