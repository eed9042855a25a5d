// A scene as pixels of a given count, for frames of films and for windows.
// SPDX-License-Identifier: MIT
#include "render/canvas/rasterise.h"

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "render/canvas/cairo_canvas.h"
#include "render/canvas/cairo_handles.h"
#include "render/canvas/page_check.h"

namespace kiri {
namespace {

std::uint8_t byteOf(std::uint32_t word, int shift) {
  return static_cast<std::uint8_t>(word >> shift & 0xFF);
}

/// cairo holds colours multiplied by their alpha.
std::uint8_t divided(std::uint8_t product, std::uint8_t alpha) {
  constexpr int kFull = 255;
  return static_cast<std::uint8_t>(std::min(kFull, (product * kFull + alpha / 2) / alpha));
}

Image pixelsOf(cairo_surface_t* surface, int width, int height, bool isOpaque) {
  Image image{width, height, {}};
  image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  cairo_surface_flush(surface);
  const unsigned char* rows = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  std::uint8_t* out = image.rgba.data();
  for (int y = 0; y < height; ++y) {
    const unsigned char* row = rows + std::ptrdiff_t{y} * stride;
    for (int x = 0; x < width; ++x, row += 4, out += 4) {
      std::uint32_t word = 0;
      std::memcpy(&word, row, sizeof word);
      const std::uint8_t alpha = isOpaque ? std::uint8_t{0xFF} : byteOf(word, 24);
      if (alpha == 0) continue;
      out[0] = divided(byteOf(word, 16), alpha);
      out[1] = divided(byteOf(word, 8), alpha);
      out[2] = divided(byteOf(word, 0), alpha);
      out[3] = alpha;
    }
  }
  return image;
}

void paintGround(cairo_t* cr, const Color& ground) {
  constexpr double kFull = 255;
  cairo_set_source_rgb(cr, ground.red / kFull, ground.green / kFull, ground.blue / kFull);
  cairo_paint(cr);
}

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
  return pixelsOf(surface.get(), width, height, ground.has_value());
}

}  // namespace

Result<Image> rasterise(const Scene& scene, int width, int height) {
  return drawn(scene, width, height, scene.background.value_or(Color{255, 255, 255}));
}

Result<Image> rasteriseTransparent(const Scene& scene, int width, int height) {
  return drawn(scene, width, height, std::nullopt);
}

}  // namespace kiri
