// Draws paper meshes with OpenGL 3.3 core or OpenGL ES 3, into whatever framebuffer is bound.
// SPDX-License-Identifier: MIT
#include "render/gl/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "render/gl/buffers.h"
#include "render/gl/program.h"
#include "render/gl/projection.h"
#include "render/gl/shaders.h"
#include "render/gl/table_shadow.h"
#include "render/gl/textures.h"
#include "render/scene/line_looks.h"

namespace kiri {
namespace {

/// Kinds of lines, each as it is and thin.
constexpr std::size_t kLooks = 2 * kMeshLines;
constexpr std::size_t kDashes = 6;
constexpr double kPixelsPerPaperMm = 96 / 25.4;
/// How much nearer lines are than their paper, in clip space: a sixteen-thousandth of the depth of
/// the picture or so. Far above what rounding may do, far below what one sees of it.
constexpr float kLift = 1.0F / 16384;

/// Uniforms of the programs, in the order of their names below.
enum PaperUniform : std::size_t {
  kPaperClip,
  kToView,
  kPaperEye,
  kShading,
  kTextureLow,
  kTextureSize,
  kFrontColor,
  kBackColor,
  kHasFrontTexture,
  kHasBackTexture,
  kHasTints,
  kFrontTexture,
  kBackTexture,
  kTints,
  kGridSpacing,
  kPaperLineScale,
};
enum ShadeUniform : std::size_t { kShadeClip, kShadeEye, kReach, kShadeBias };
enum LineUniform : std::size_t {
  kLineClip,
  kEye,
  kHalfSize,
  kPixelsPerMm,
  kBias,
  kFlatSlope,
  kWidths,
  kColors,
  kDashPattern,
  kDashLengths,
  kLineScale,
};

/// How lines look, for a pixel of the window.
struct LineLooks {
  std::array<float, kLooks> widths{};
  std::array<float, kLooks * 3> colors{};
  std::array<float, kLooks * kDashes> dashes{};
  std::array<float, kLooks> dashLengths{};
};

LineKind lineKindOf(MeshLine line) {
  switch (line) {
    case MeshLine::Border:
    case MeshLine::Edge:
      return LineKind::Border;
    case MeshLine::Crease:
      return LineKind::Flat;
    case MeshLine::Mountain:
      return LineKind::Mountain;
    case MeshLine::Valley:
      return LineKind::Valley;
    case MeshLine::Tear:
      return LineKind::Tear;
  }
  return LineKind::Border;
}

double widthOf(MeshLine line, bool isThin, const Appearance& appearance) {
  if (isThin || line == MeshLine::Crease) return appearance.creaseWidth;
  const bool isDrawn = line == MeshLine::Mountain || line == MeshLine::Valley;
  return isDrawn ? appearance.drawnWidth : appearance.edgeWidth;
}

LineLooks lineLooksOf(const Appearance& appearance) {
  LineLooks out;
  for (std::size_t i = 0; i < kLooks; ++i) {
    const auto line = static_cast<MeshLine>(i % kMeshLines);
    const double width = widthOf(line, i >= kMeshLines, appearance);
    const Stroke stroke = strokeFor(lineKindOf(line), appearance, width);
    // Fainter than a pixel is hard to see on a screen.
    out.widths[i] = static_cast<float>(std::max(stroke.width * kPixelsPerPaperMm, 1.0));
    const std::array<std::uint8_t, 3> rgb{stroke.color.red, stroke.color.green, stroke.color.blue};
    for (std::size_t c = 0; c < 3; ++c) out.colors[3 * i + c] = static_cast<float>(rgb[c]) / 255;
    for (std::size_t d = 0; d < stroke.dashes.size() && d < kDashes; ++d) {
      const auto dash = static_cast<float>(stroke.dashes[d] * kPixelsPerPaperMm);
      out.dashes[kDashes * i + d] = dash;
      out.dashLengths[i] += dash;
    }
  }
  return out;
}

bool isShown(MeshLine line, const GlView& view) {
  switch (line) {
    case MeshLine::Border:
      return view.showsBorders;
    case MeshLine::Edge:
    case MeshLine::Tear:
      return view.showsEdges;
    default:
      return view.showsCreases;
  }
}

void setColor(GLint uniform, Color color) {
  glUniform3f(uniform, static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
              static_cast<float>(color.blue) / 255);
}

void bindTexture(GLenum unit, GLuint texture) {
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, texture);
}

/// Lower than this the table is a line.
bool seesTable(const ViewFrame& frame) {
  constexpr double kLowest = 0.03;
  return frame.toEye.z > kLowest;
}

/// What draw() promises to leave.
void tidyUp() {
  glDisable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ZERO);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glBindVertexArray(0);
  glUseProgram(0);
  bindTexture(GL_TEXTURE2, 0);
  bindTexture(GL_TEXTURE1, 0);
  bindTexture(GL_TEXTURE0, 0);
}

std::string ownWords(GLenum what) {
  const GLubyte* words = glGetString(what);
  std::string out;
  for (; words != nullptr && *words != 0; ++words) out += static_cast<char>(*words);
  return out;
}

std::string nameOfContext() {
  const int version = epoxy_gl_version();
  return std::string(epoxy_is_desktop_gl() ? "OpenGL " : "OpenGL ES ") +
         std::to_string(version / 10) + "." + std::to_string(version % 10) + ", " +
         ownWords(GL_RENDERER);
}

}  // namespace

struct GlRenderer::Gpu {
  explicit Gpu(const std::string& header)
      : paper(header, kPaperVertexShader, kPaperFragmentShader,
              {"clip", "toView", "eye", "shading", "textureLow", "textureSize", "frontColor",
               "backColor", "hasFrontTexture", "hasBackTexture", "hasTints", "frontTexture",
               "backTexture", "tints", "gridSpacing", "lineScale"}),
        shades(header, kShadeVertexShader, kShadeFragmentShader, {"clip", "eye", "reach", "bias"}),
        lines(header, kLineVertexShader, kLineFragmentShader,
              {"clip", "eye", "halfSize", "pixelsPerMm", "bias", "flatSlope", "widths", "colors",
               "dashes", "dashLengths", "lineScale"}),
        shadow(header) {}

  void drawPaper(const GlView& view) const;
  void drawShades(const GlView& view) const;
  void drawLines(const GlView& view) const;

  Program paper;
  Program shades;
  Program lines;
  TableShadow shadow;
  MeshBuffers buffers;
  SideTexture front;
  SideTexture back;
  TintTable tints;
  Appearance appearance;
  LineLooks looks = lineLooksOf({});
  Vec3 origin;
  std::uint32_t facetCount = 0;
};

void GlRenderer::Gpu::drawPaper(const GlView& view) const {
  paper.use();
  glUniformMatrix4fv(paper[kPaperClip], 1, GL_FALSE, clipMatrix(view, origin).data());
  glUniformMatrix3fv(paper[kToView], 1, GL_FALSE, viewMatrix(view.frame).data());
  glUniform4fv(paper[kPaperEye], 1, eyeOf(view.frame, origin).data());
  glUniform1f(paper[kShading], view.isShaded ? 1.0F : 0.0F);
  const Box& box = appearance.textureBox;
  const Vec2 size = box.high - box.low;
  glUniform2f(paper[kTextureLow], static_cast<float>(box.low.x), static_cast<float>(box.low.y));
  glUniform2f(paper[kTextureSize], static_cast<float>(size.x), static_cast<float>(size.y));
  setColor(paper[kFrontColor], appearance.front.color);
  setColor(paper[kBackColor], appearance.back.color);
  const bool hasTints = facetCount > 0 && tints.size() >= facetCount;
  glUniform1i(paper[kHasFrontTexture], front.isThere() ? 1 : 0);
  glUniform1i(paper[kHasBackTexture], back.isThere() ? 1 : 0);
  glUniform1i(paper[kHasTints], hasTints ? 1 : 0);
  glUniform1i(paper[kFrontTexture], 0);
  glUniform1i(paper[kBackTexture], 1);
  glUniform1i(paper[kTints], 2);
  glUniform1f(paper[kGridSpacing], static_cast<float>(view.gridSpacing));
  glUniform1f(paper[kPaperLineScale], static_cast<float>(view.lineScale));
  bindTexture(GL_TEXTURE2, hasTints ? tints.id() : 0);
  bindTexture(GL_TEXTURE1, back.id());
  bindTexture(GL_TEXTURE0, front.id());
  buffers.drawPaper();
}

void GlRenderer::Gpu::drawShades(const GlView& view) const {
  constexpr double kReachPixels = 9;
  shades.use();
  glUniformMatrix4fv(shades[kShadeClip], 1, GL_FALSE, clipMatrix(view, origin).data());
  glUniform4fv(shades[kShadeEye], 1, eyeOf(view.frame, origin).data());
  glUniform1f(shades[kReach], static_cast<float>(kReachPixels * view.lineScale / view.pixelsPerMm));
  glUniform1f(shades[kShadeBias], kLift / 2);
  buffers.drawShades();
}

void GlRenderer::Gpu::drawLines(const GlView& view) const {
  lines.use();
  const auto scale = static_cast<float>(view.lineScale);
  LineLooks shown = looks;
  for (std::size_t i = 0; i < kLooks; ++i) {
    const bool isOn = isShown(static_cast<MeshLine>(i % kMeshLines), view);
    shown.widths[i] = isOn ? shown.widths[i] * scale : 0;
    shown.dashLengths[i] *= scale;
  }
  for (float& dash : shown.dashes) dash *= scale;
  const std::array<float, 4> eye = eyeOf(view.frame, origin);
  glUniformMatrix4fv(lines[kLineClip], 1, GL_FALSE, clipMatrix(view, origin).data());
  glUniform4fv(lines[kEye], 1, eye.data());
  glUniform2f(lines[kHalfSize], static_cast<float>(view.width) / 2,
              static_cast<float>(view.height) / 2);
  glUniform1f(lines[kPixelsPerMm], static_cast<float>(view.pixelsPerMm));
  glUniform1f(lines[kBias], kLift);
  glUniform1f(lines[kFlatSlope], flatSlopeOf(view));
  glUniform1fv(lines[kWidths], kLooks, shown.widths.data());
  glUniform3fv(lines[kColors], kLooks, shown.colors.data());
  glUniform1fv(lines[kDashPattern], kLooks * kDashes, shown.dashes.data());
  glUniform1fv(lines[kDashLengths], kLooks, shown.dashLengths.data());
  glUniform1f(lines[kLineScale], scale);
  buffers.drawLines();
}

Result<std::unique_ptr<GlRenderer>> GlRenderer::create() {
  const int needed = epoxy_is_desktop_gl() ? 33 : 30;
  if (epoxy_gl_version() < needed) {
    return Error{ErrorCode::BadValue,
                 "drawing needs OpenGL 3.3 or OpenGL ES 3.0, and here is " + nameOfContext()};
  }
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::make_unique<Gpu>(shaderHeader())));
}

GlRenderer::GlRenderer(std::unique_ptr<Gpu> gpu) : gpu_(std::move(gpu)) {}
GlRenderer::~GlRenderer() = default;

void GlRenderer::setMesh(const PaperMesh& mesh) {
  gpu_->origin = mesh.origin;
  gpu_->facetCount = mesh.facetCount;
  gpu_->buffers.upload(mesh);
  gpu_->shadow.setMesh(mesh);
}

void GlRenderer::setTints(const std::vector<TintColor>& tints) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(tints.size() * 4);
  for (const TintColor& tint : tints) {
    rgba.insert(rgba.end(), {tint.red, tint.green, tint.blue, tint.alpha});
  }
  gpu_->tints.set(std::move(rgba));
}

void GlRenderer::setAppearance(const Appearance& appearance) {
  gpu_->appearance = appearance;
  gpu_->looks = lineLooksOf(appearance);
  gpu_->front.set(appearance.front.texture);
  gpu_->back.set(appearance.back.texture);
}

void GlRenderer::draw(const GlView& view) {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  if (epoxy_is_desktop_gl()) glDisable(GL_FRAMEBUFFER_SRGB);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  const bool hasShadow = view.hasShadow && seesTable(view.frame) && gpu_->facetCount > 0;
  if (hasShadow) gpu_->shadow.prepare(gpu_->buffers);
  glViewport(0, 0, view.width, view.height);
  const auto unit = [](std::uint8_t c) { return static_cast<float>(c) / 255; };
  glClearColor(unit(view.background.red), unit(view.background.green), unit(view.background.blue),
               1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (hasShadow) {
    glEnable(GL_BLEND);
    gpu_->shadow.draw(clipMatrix(view, gpu_->origin));
    glDisable(GL_BLEND);
  }

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  gpu_->drawPaper(view);

  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  if (view.isShaded) gpu_->drawShades(view);
  gpu_->drawLines(view);
  tidyUp();
}

std::string GlRenderer::description() const { return nameOfContext(); }

}  // namespace kiri
