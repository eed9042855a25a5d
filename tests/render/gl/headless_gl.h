// An OpenGL context without a screen, and a framebuffer with four samples to draw into.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "render/scene/image.h"

namespace kiri::test {

enum class GlKind { Desktop33, Es30 };

class HeadlessGl {
 public:
  /// Null when there is no EGL that draws without a screen; `why` says what is missing.
  static std::unique_ptr<HeadlessGl> create(GlKind kind, std::string& why);
  ~HeadlessGl();
  HeadlessGl(const HeadlessGl&) = delete;
  HeadlessGl& operator=(const HeadlessGl&) = delete;

  /// Makes the framebuffer current, with that many pixels and samples (0: one, not smoothed).
  void begin(int width, int height, int samples = 4);
  /// What was drawn since.
  Image finish();
  /// The first error that OpenGL has kept, as a number; 0: none.
  unsigned error() const;
  /// The names of what is not as it is in a new context, of what drawing changes.
  std::string changedState() const;

 private:
  struct Handles;
  explicit HeadlessGl(std::unique_ptr<Handles> handles);
  void drop();
  std::unique_ptr<Handles> handles_;
};

}  // namespace kiri::test
