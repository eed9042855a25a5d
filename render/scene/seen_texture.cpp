// Textures in perspective.
// SPDX-License-Identifier: MIT
#include "render/scene/seen_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kiri {
namespace {

Affine inverse(const Affine& m) {
  const double det = m.a * m.d - m.b * m.c;
  return {m.d / det,
          -m.b / det,
          -m.c / det,
          m.a / det,
          (m.c * m.f - m.d * m.e) / det,
          (m.b * m.e - m.a * m.f) / det};
}

/// The colour at a place given in pixels, y down, between the four pixels around it.
std::array<std::uint8_t, 4> sampled(const Image& image, Vec2 at) {
  const auto pixel = [&](int x, int y) {
    const auto column = static_cast<std::size_t>(std::clamp(x, 0, image.width - 1));
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, image.height - 1));
    return &image.rgba[(row * static_cast<std::size_t>(image.width) + column) * 4];
  };
  const double x = std::clamp(at.x - 0.5, -1.0, 1.0 * image.width);
  const double y = std::clamp(at.y - 0.5, -1.0, 1.0 * image.height);
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  std::array<double, 4> sum{};  // colours count by their alpha
  for (const int dy : {0, 1}) {
    for (const int dx : {0, 1}) {
      const std::uint8_t* p = pixel(x0 + dx, y0 + dy);
      const double weight = (dx == 0 ? x0 + 1 - x : x - x0) * (dy == 0 ? y0 + 1 - y : y - y0);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * p[3] * p[c];
      sum[3] += weight * p[3];
    }
  }
  std::array<std::uint8_t, 4> out{};
  if (!(sum[3] > 0)) return out;
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = static_cast<std::uint8_t>(std::lround(sum[c] / sum[3]));
  }
  out[3] = static_cast<std::uint8_t>(std::lround(sum[3]));
  return out;
}

}  // namespace

std::shared_ptr<const Image> seenTexture(const Image& texture, const Affine& imageToPaper,
                                         const Rigid& pose, const ViewFrame& view, const Box& box) {
  // Pixels of the texture on a mm of paper, and of the result on a mm of the view, where paper may
  // look up to several times as large; pixels that are smaller by half lose nothing.
  const double perMm = std::max(texture.width / std::hypot(imageToPaper.a, imageToPaper.b),
                                texture.height / std::hypot(imageToPaper.c, imageToPaper.d));
  constexpr double kFiner = 1.5;
  constexpr double kMost = 4096;
  const Vec2 size = box.high - box.low;
  const auto pixels = [&](double mm) {
    return static_cast<int>(std::clamp(std::ceil(mm * perMm * kFiner), 1.0, kMost));
  };
  auto out = std::make_shared<Image>(Image{pixels(size.x), pixels(size.y), {}});
  out->rgba.reserve(static_cast<std::size_t>(out->width) * static_cast<std::size_t>(out->height) *
                    4);
  const Affine paperToImage = inverse(imageToPaper);
  for (int row = 0; row < out->height; ++row) {
    for (int column = 0; column < out->width; ++column) {
      const Vec2 p{box.low.x + size.x * (column + 0.5) / out->width,
                   box.high.y - size.y * (row + 0.5) / out->height};
      const Vec2 unit =
          paperToImage.apply(pose.pullBack(view.onPlane(p, pose.origin, pose.normal())));
      for (const std::uint8_t c :
           sampled(texture, {unit.x * texture.width, (1 - unit.y) * texture.height})) {
        out->rgba.push_back(c);
      }
    }
  }
  return out;
}

}  // namespace kiri
