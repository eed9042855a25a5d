// Pictures on the graphics processor.
// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "render/scene/image.h"

namespace kiri {

/// The texture of one side of the paper.
class SideTexture {
 public:
  SideTexture() = default;
  ~SideTexture();
  SideTexture(const SideTexture&) = delete;
  SideTexture& operator=(const SideTexture&) = delete;

  /// Does nothing when it is the same image as before. Images larger than the graphics processor
  /// takes are halved until they fit.
  void set(const std::shared_ptr<const Image>& image);
  bool isThere() const { return image_ != nullptr; }
  GLuint id() const { return id_; }

 private:
  std::shared_ptr<const Image> image_;
  GLuint id_ = 0;
};

/// One RGBA colour for each number, kTintsInRow in a row.
class TintTable {
 public:
  static constexpr int kTintsInRow = 1024;
  TintTable() = default;
  ~TintTable();
  TintTable(const TintTable&) = delete;
  TintTable& operator=(const TintTable&) = delete;

  void set(std::vector<std::uint8_t> rgba);
  std::size_t size() const { return count_; }
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
  std::size_t count_ = 0;
  int rows_ = 0;
};

}  // namespace kiri
