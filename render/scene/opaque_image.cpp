// Images without anything see-through.
// SPDX-License-Identifier: MIT
#include "render/scene/opaque_image.h"

#include <cstddef>
#include <cstdint>

namespace kiri {

Image overColor(Image image, Color paper) {
  constexpr int kFull = 255;
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    const int alpha = image.rgba[i + 3];
    const std::uint8_t under[] = {paper.red, paper.green, paper.blue};
    for (std::size_t k = 0; k < 3; ++k) {
      const int mixed = image.rgba[i + k] * alpha + under[k] * (kFull - alpha);
      image.rgba[i + k] = static_cast<std::uint8_t>((mixed + kFull / 2) / kFull);
    }
    image.rgba[i + 3] = kFull;
  }
  return image;
}

}  // namespace kiri
