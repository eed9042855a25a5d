// The soft shadow that the model casts on the table it lies on.
// SPDX-License-Identifier: MIT
#include "render/gl/table_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/rigid.h"
#include "render/gl/shaders.h"

namespace kiri {
namespace {

constexpr int kSize = 448;  // pixels of the shadow's picture
constexpr int kLights = 16;
constexpr double kLampRadius = 0.14;  // of its distance: the softness
constexpr float kDarkness = 0.26F;

enum FallUniform : std::size_t { kLight, kFallBox, kFallTable, kDepth, kShare };
enum TableUniform : std::size_t { kClip, kBox, kTable, kShadow, kTexel, kDark };

/// How far aside light from the points of the lamp goes on its way down by 1. A sunflower's seeds
/// fill the disc of the lamp evenly.
std::array<Vec2, kLights> lights() {
  const Vec2 middle = Vec2{-0.42, 0.5} / 1.2;
  constexpr double kGoldenAngle = 137.50776405003785;
  std::array<Vec2, kLights> out;
  for (std::size_t i = 0; i < kLights; ++i) {
    const double number = static_cast<double>(i);
    const double radius = kLampRadius * std::sqrt((number + 0.5) / kLights);
    const CosSin turn = cosSinDegrees(kGoldenAngle * number);
    out[i] = middle + Vec2{turn.cos, turn.sin} * radius;
  }
  return out;
}

}  // namespace

TableShadow::TableShadow(const std::string& header)
    : fall_(header, kFallVertexShader, kFallFragmentShader,
            {"light", "box", "table", "depth", "share"}),
      table_(header, kTableVertexShader, kTableFragmentShader,
             {"clip", "box", "table", "shadow", "texel", "darkness"}) {}

TableShadow::~TableShadow() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteRenderbuffers(1, &depth_);
  glDeleteTextures(1, &texture_);
  glDeleteVertexArrays(1, &nothing_);
}

void TableShadow::makeTarget() {
  glGenVertexArrays(1, &nothing_);
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kSize, kSize, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  glGenRenderbuffers(1, &depth_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, kSize, kSize);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
}

void TableShadow::setMesh(const PaperMesh& mesh) {
  isStale_ = true;
  if (mesh.vertices.empty()) return;
  constexpr float kFar = std::numeric_limits<float>::max();
  std::array<float, 3> low{kFar, kFar, kFar};
  std::array<float, 3> high{-kFar, -kFar, -kFar};
  for (const MeshVertex& v : mesh.vertices) {
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], v.position[c]);
      high[c] = std::max(high[c], v.position[c]);
    }
  }
  // A little below the paper, so that even a flat sheet has a soft rim.
  constexpr float kClear = 0.01F;
  const float size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  height_ = low[2] - kClear * size;
  // What falls from the top goes aside the farthest.
  const float drop = high[2] - height_;
  for (const Vec2 light : lights()) {
    const auto x = static_cast<float>(light.x) * drop;
    const auto y = static_cast<float>(light.y) * drop;
    low = {std::min(low[0], low[0] - x), std::min(low[1], low[1] - y), low[2]};
    high = {std::max(high[0], high[0] - x), std::max(high[1], high[1] - y), high[2]};
  }
  constexpr float kRoom = 1.04F;
  box_ = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2,
          std::max((high[0] - low[0]) / 2, size * kClear) * kRoom,
          std::max((high[1] - low[1]) / 2, size * kClear) * kRoom};
}

void TableShadow::prepare(const MeshBuffers& buffers) {
  if (!isStale_) return;
  isStale_ = false;
  GLint callers = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &callers);
  if (framebuffer_ == 0) makeTarget();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, kSize, kSize);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
  fall_.use();
  glUniform4fv(fall_[kFallBox], 1, box_.data());
  glUniform1f(fall_[kFallTable], height_);
  glUniform1f(fall_[kShare], 1.0F / kLights);
  // Each light is a little nearer than the one before: whatever many layers hide a place from it,
  // only the first of them counts.
  float depth = 1;
  for (const Vec2 light : lights()) {
    depth -= 1.0F / kLights;
    glUniform2f(fall_[kLight], static_cast<float>(light.x), static_cast<float>(light.y));
    glUniform1f(fall_[kDepth], depth);
    buffers.drawPaper();
  }
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(callers));
}

void TableShadow::draw(const std::array<float, 16>& clip) const {
  table_.use();
  glUniformMatrix4fv(table_[kClip], 1, GL_FALSE, clip.data());
  glUniform4fv(table_[kBox], 1, box_.data());
  glUniform1f(table_[kTable], height_);
  glUniform1i(table_[kShadow], 0);
  glUniform1f(table_[kTexel], 1.0F / kSize);
  glUniform1f(table_[kDark], kDarkness);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glBindVertexArray(nothing_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace kiri
