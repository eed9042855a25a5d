// Pictures on the graphics processor.
// SPDX-License-Identifier: MIT
#include "render/gl/textures.h"

#include <algorithm>

namespace kiri {
namespace {

/// Colours count by their alpha when pixels are mixed.
std::vector<std::uint8_t> premultiplied(const Image& image) {
  std::vector<std::uint8_t> out = image.rgba;
  for (std::size_t i = 0; i + 3 < out.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      out[i + c] = static_cast<std::uint8_t>((out[i + c] * out[i + 3] + 127) / 255);
    }
  }
  return out;
}

/// Half as wide and high, four pixels for one.
Image halved(const Image& image) {
  Image out{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
  const auto at = [&](int x, int y, int c) {
    const auto column = static_cast<std::size_t>(std::min(x, image.width - 1));
    const auto row = static_cast<std::size_t>(std::min(y, image.height - 1));
    return image.rgba[(row * static_cast<std::size_t>(image.width) + column) * 4 +
                      static_cast<std::size_t>(c)];
  };
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        const int sum = at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) +
                        at(2 * x + 1, 2 * y + 1, c);
        out.rgba.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return out;
}

GLuint newTexture(GLint minify, GLint magnify) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return id;
}

/// Paper is often seen at a slant: without this its texture blurs there.
void sharpenAtASlant() {
  if (!epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) return;
  constexpr GLfloat kWanted = 8;
  GLfloat most = 1;
  glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(most, kWanted));
}

}  // namespace

SideTexture::~SideTexture() {
  if (id_ != 0) glDeleteTextures(1, &id_);
}

void SideTexture::set(const std::shared_ptr<const Image>& image) {
  if (image == image_) return;
  image_ = image;
  if (id_ != 0) glDeleteTextures(1, &id_);
  id_ = 0;
  if (!image) return;
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  Image pixels{image->width, image->height, premultiplied(*image)};
  while (pixels.width > most || pixels.height > most) pixels = halved(pixels);
  id_ = newTexture(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  sharpenAtASlant();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, pixels.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, 0);
}

TintTable::~TintTable() {
  if (id_ != 0) glDeleteTextures(1, &id_);
}

void TintTable::set(std::vector<std::uint8_t> rgba) {
  count_ = rgba.size() / 4;
  if (count_ == 0) return;
  const auto inRow = static_cast<std::size_t>(kTintsInRow);
  const std::size_t rows = (count_ + inRow - 1) / inRow;
  rgba.resize(rows * inRow * 4, 0);
  if (id_ == 0) id_ = newTexture(GL_NEAREST, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (rows_ != static_cast<int>(rows)) {
    rows_ = static_cast<int>(rows);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kTintsInRow, rows_, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.data());
  } else {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTintsInRow, rows_, GL_RGBA, GL_UNSIGNED_BYTE,
                    rgba.data());
  }
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace kiri
