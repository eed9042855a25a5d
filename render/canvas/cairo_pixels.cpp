// The pixels of cairo's images, and the ground below them.
// SPDX-License-Identifier: MIT
#include "render/canvas/cairo_pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

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

}  // namespace

Image pixelsOf(cairo_surface_t* surface) {
  const bool isOpaque = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_RGB24;
  Image image{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  image.rgba.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                    4);
  cairo_surface_flush(surface);
  const unsigned char* rows = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  std::uint8_t* out = image.rgba.data();
  for (int y = 0; y < image.height; ++y) {
    const unsigned char* row = rows + std::ptrdiff_t{y} * stride;
    for (int x = 0; x < image.width; ++x, row += 4, out += 4) {
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

}  // namespace kiri
