// A compiled program and where its uniforms are.
// SPDX-License-Identifier: MIT
#include "render/gl/program.h"

#include <array>

#include "core/base/check.h"

namespace kiri {
namespace {

GLuint compiled(GLenum kind, const std::string& header, const char* source) {
  const GLuint shader = glCreateShader(kind);
  const std::array<const char*, 2> parts{header.c_str(), source};
  glShaderSource(shader, 2, parts.data(), nullptr);
  glCompileShader(shader);
  GLint isFine = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &isFine);
  if (isFine == 0) {
    std::array<char, 2048> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    KIRI_CHECK(isFine != 0, log.data());
  }
  return shader;
}

}  // namespace

std::string shaderHeader() {
  if (epoxy_is_desktop_gl()) return "#version 330 core\n";
  return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp "
         "sampler2D;\n";
}

Program::Program(const std::string& header, const char* vertex, const char* fragment,
                 std::initializer_list<const char*> uniforms)
    : id_(glCreateProgram()) {
  const GLuint first = compiled(GL_VERTEX_SHADER, header, vertex);
  const GLuint second = compiled(GL_FRAGMENT_SHADER, header, fragment);
  glAttachShader(id_, first);
  glAttachShader(id_, second);
  glLinkProgram(id_);
  glDeleteShader(first);
  glDeleteShader(second);
  GLint isFine = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &isFine);
  KIRI_CHECK(isFine != 0, "the shaders fit each other");
  for (const char* name : uniforms) places_.push_back(glGetUniformLocation(id_, name));
}

Program::~Program() { glDeleteProgram(id_); }

void Program::use() const { glUseProgram(id_); }

}  // namespace kiri
