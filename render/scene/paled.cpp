// Mixes white into colours.
// SPDX-License-Identifier: MIT
#include "render/scene/paled.h"

#include <cmath>
#include <cstdint>

namespace kiri {

Appearance paledFor(const Appearance& appearance, double white) {
  const auto mixed = [white](std::uint8_t part) {
    return static_cast<std::uint8_t>(std::lround(part + (255 - part) * white));
  };
  const Color front = appearance.front.color;
  Appearance pale = appearance;
  pale.front = {{mixed(front.red), mixed(front.green), mixed(front.blue)}, nullptr};
  return pale;
}

}  // namespace kiri
