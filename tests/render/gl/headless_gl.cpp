// An OpenGL context without a screen, and a framebuffer with four samples to draw into.
// SPDX-License-Identifier: MIT
#include "tests/render/gl/headless_gl.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace kiri::test {

struct HeadlessGl::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  int width = 0;
  int height = 0;
  GLuint framebuffer = 0;
  GLuint resolved = 0;
  std::array<GLuint, 3> renderbuffers{};  ///< colour, depth, resolved colour
};

namespace {

EGLContext contextOf(EGLDisplay display, GlKind kind) {
  const bool isDesktop = kind == GlKind::Desktop33;
  if (eglBindAPI(isDesktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API) == EGL_FALSE)
    return EGL_NO_CONTEXT;
  const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE,
                                     isDesktop ? EGL_OPENGL_BIT : EGL_OPENGL_ES3_BIT,
                                     EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0)
    return EGL_NO_CONTEXT;
  std::vector<EGLint> form{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                           isDesktop ? 3 : 0};
  if (isDesktop) {
    form.insert(form.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
  }
  form.push_back(EGL_NONE);
  return eglCreateContext(display, config, EGL_NO_CONTEXT, form.data());
}

GLuint storage(GLint samples, GLenum format, int width, int height) {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return id;
}

}  // namespace

HeadlessGl::HeadlessGl(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}

std::unique_ptr<HeadlessGl> HeadlessGl::create(GlKind kind, std::string& why) {
  auto handles = std::make_unique<Handles>();
  if (!epoxy_has_egl() ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    why = "no EGL here draws without a screen (EGL_MESA_platform_surfaceless)";
    return nullptr;
  }
  handles->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (handles->display == EGL_NO_DISPLAY ||
      eglInitialize(handles->display, nullptr, nullptr) == EGL_FALSE) {
    why = "EGL does not start";
    return nullptr;
  }
  handles->context = contextOf(handles->display, kind);
  if (handles->context == EGL_NO_CONTEXT ||
      eglMakeCurrent(handles->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles->context) ==
          EGL_FALSE) {
    why = "EGL has no context of that kind";
    return nullptr;
  }
  return std::unique_ptr<HeadlessGl>(new HeadlessGl(std::move(handles)));
}

HeadlessGl::~HeadlessGl() {
  drop();
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(handles_->display, handles_->context);
}

void HeadlessGl::drop() {
  glDeleteFramebuffers(1, &handles_->framebuffer);
  glDeleteFramebuffers(1, &handles_->resolved);
  glDeleteRenderbuffers(3, handles_->renderbuffers.data());
}

void HeadlessGl::begin(int width, int height, int samples) {
  drop();
  Handles& h = *handles_;
  h.width = width;
  h.height = height;
  h.renderbuffers = {storage(samples, GL_RGBA8, width, height),
                     storage(samples, GL_DEPTH_COMPONENT24, width, height),
                     storage(0, GL_RGBA8, width, height)};
  glGenFramebuffers(1, &h.resolved);
  glBindFramebuffer(GL_FRAMEBUFFER, h.resolved);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            h.renderbuffers[2]);
  glGenFramebuffers(1, &h.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            h.renderbuffers[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                            h.renderbuffers[1]);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("no framebuffer with four samples");
}

Image HeadlessGl::finish() {
  const Handles& h = *handles_;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, h.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, h.resolved);
  glBlitFramebuffer(0, 0, h.width, h.height, 0, 0, h.width, h.height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, h.resolved);
  const std::size_t row = static_cast<std::size_t>(h.width) * 4;
  std::vector<std::uint8_t> upward(row * static_cast<std::size_t>(h.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, h.width, h.height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
  glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
  Image image{h.width, h.height, {}};
  image.rgba.reserve(upward.size());
  for (std::size_t y = upward.size(); y > 0; y -= row) {
    image.rgba.insert(image.rgba.end(), upward.begin() + static_cast<std::ptrdiff_t>(y - row),
                      upward.begin() + static_cast<std::ptrdiff_t>(y));
  }
  return image;
}

unsigned HeadlessGl::error() const { return glGetError(); }

std::string HeadlessGl::changedState() const {
  std::string out;
  const auto expect = [&](GLenum what, GLint expected, const char* name) {
    GLint found = 0;
    glGetIntegerv(what, &found);
    if (found != expected) out += std::string(name) + " ";
  };
  expect(GL_DEPTH_TEST, 0, "depth test");
  expect(GL_CULL_FACE, 0, "culling");
  expect(GL_BLEND, 0, "blending");
  expect(GL_SCISSOR_TEST, 0, "scissor test");
  expect(GL_DEPTH_WRITEMASK, 1, "depth mask");
  expect(GL_DEPTH_FUNC, GL_LESS, "depth function");
  expect(GL_BLEND_SRC_RGB, GL_ONE, "blend source");
  expect(GL_BLEND_DST_RGB, GL_ZERO, "blend destination");
  expect(GL_CURRENT_PROGRAM, 0, "program");
  expect(GL_VERTEX_ARRAY_BINDING, 0, "vertex array");
  expect(GL_ARRAY_BUFFER_BINDING, 0, "buffer");
  expect(GL_ACTIVE_TEXTURE, GL_TEXTURE0, "texture unit");
  expect(GL_TEXTURE_BINDING_2D, 0, "texture");
  return out;
}

}  // namespace kiri::test
