// A scene as pixels of a given count, for frames of films and for windows.
// SPDX-License-Identifier: MIT
#include "render/canvas/rasterise.h"

#include <cairo.h>

#include <algorithm>
#include <optional>
#include <string>

#include "render/canvas/cairo_canvas.h"
#include "render/canvas/cairo_handles.h"
#include "render/canvas/cairo_pixels.h"
#include "render/canvas/page_check.h"

namespace kiri {
namespace {

/// On a ground, or on nothing.
Result<Image> drawn(const Scene& scene, int width, int height, const std::optional<Color>& ground) {
  const Status size = checkPage(scene);
  if (!size) return size.error();
  constexpr int kMost = 16384;
  if (width < 1 || height < 1 || width > kMost || height > kMost) {
    return Error{ErrorCode::BadValue,
                 "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels cannot be made; give 1 to 16384 on a side",
                 {}};
  }
  const CairoSurface surface(
      cairo_image_surface_create(ground ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, width, height));
  const CairoContext cr(cairo_create(surface.get()));
  const double perMm = std::min(width / scene.width, height / scene.height);
  if (ground) paintGround(cr.get(), *ground);
  cairo_translate(cr.get(), (width - scene.width * perMm) / 2, (height - scene.height * perMm) / 2);
  cairo_scale(cr.get(), perMm, perMm);
  constexpr double kSeamPixels = 3;
  drawScene(cr.get(), scene, kSeamPixels / perMm);
  if (cairo_status(cr.get()) != CAIRO_STATUS_SUCCESS) {
    return Error{ErrorCode::BadValue,
                 std::string("the frame could not be drawn: ") +
                     cairo_status_to_string(cairo_status(cr.get())) + "; try a smaller size",
                 {}};
  }
  return pixelsOf(surface.get());
}

}  // namespace

Result<Image> rasterise(const Scene& scene, int width, int height) {
  return drawn(scene, width, height, scene.background.value_or(Color{255, 255, 255}));
}

Result<Image> rasteriseTransparent(const Scene& scene, int width, int height) {
  return drawn(scene, width, height, std::nullopt);
}

}  // namespace kiri
