// A compiled program and where its uniforms are.
// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace kiri {

/// "#version" and precisions of the current context.
std::string shaderHeader();

class Program {
 public:
  Program() = default;
  /// Sources without header. `uniforms`: names, by whose places in the list they are set later.
  Program(const std::string& header, const char* vertex, const char* fragment,
          std::initializer_list<const char*> uniforms);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const;
  GLint operator[](std::size_t uniform) const { return places_[uniform]; }

 private:
  GLuint id_ = 0;
  std::vector<GLint> places_;
};

}  // namespace kiri
