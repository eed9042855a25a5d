// A picture made of pixels, for textures.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace kiri {

/// Rows from the top, four bytes (red, green, blue, alpha; not premultiplied) for each pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace kiri
