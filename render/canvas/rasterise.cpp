// A scene as pixels of a given count, for frames of films and for windows.
// SPDX-License-Identifier: MIT
#include "render/canvas/rasterise.h"

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "render/canvas/cairo_canvas.h"
#include "render/canvas/page_check.h"

namespace kiri {
namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cr) const { cairo_destroy(cr); }
};

Image pixelsOf(cairo_surface_t* surface, int width, int height) {
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
      out[0] = static_cast<std::uint8_t>(word >> 16 & 0xFF);
      out[1] = static_cast<std::uint8_t>(word >> 8 & 0xFF);
      out[2] = static_cast<std::uint8_t>(word & 0xFF);
      out[3] = 0xFF;
    }
  }
  return image;
}

}  // namespace

Result<Image> rasterise(const Scene& scene, int width, int height) {
  const Status size = checkPage(scene);
  if (!size) return size.error();
  constexpr int kMost = 16384;
  if (width < 1 || height < 1 || width > kMost || height > kMost) {
    return Error{ErrorCode::BadValue,
                 "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels cannot be made; give 1 to 16384 on a side",
                 {}};
  }
  const std::unique_ptr<cairo_surface_t, Destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  const std::unique_ptr<cairo_t, Destroy> cr(cairo_create(surface.get()));
  const double perMm = std::min(width / scene.width, height / scene.height);
  const Color ground = scene.background.value_or(Color{255, 255, 255});
  constexpr double kFull = 255;
  cairo_set_source_rgb(cr.get(), ground.red / kFull, ground.green / kFull, ground.blue / kFull);
  cairo_paint(cr.get());
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
  return pixelsOf(surface.get(), width, height);
}

}  // namespace kiri
