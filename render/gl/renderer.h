// Draws paper meshes with OpenGL 3.3 core or OpenGL ES 3, into whatever framebuffer is bound.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "render/mesh/paper_mesh.h"
#include "render/scene/appearance.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// What a picture shows. All of it may change from frame to frame at no cost.
struct GlView {
  ViewFrame frame;
  double pixelsPerMm = 3;  ///< of the framebuffer, not of the window
  Vec2 centre;             ///< view coordinates of the middle of the picture, mm
  int width = 1;           ///< pixels of the framebuffer
  int height = 1;
  /// ViewFrame::depth between which everything lies, in either order. The nearer they are to each
  /// other, the finer the depth buffer.
  double nearDepth = -1000;
  double farDepth = 1000;
  Color background{250, 250, 250};
  bool showsEdges = true;    ///< MeshLine::Edge and Tear
  bool showsCreases = true;  ///< Crease, Mountain, Valley
  bool showsBorders = true;  ///< Border
  double gridSpacing = 0;    ///< mm on the paper, from its origin; 0: none
  bool isShaded = true;      ///< soft light
  bool hasShadow = false;    ///< on a table under the model, for an eye above it
  double lineScale = 1;      ///< device pixels for a pixel of the window
};

/// An RGBA colour over a facet: 0 to 255, alpha is how much of it.
struct TintColor {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 0;
};

/// Owns buffers and programs of one OpenGL context, which must be current in every call and in the
/// destructor.
class GlRenderer {
 public:
  /// Errors: BadValue - the context is older than OpenGL 3.3 or OpenGL ES 3.0, with what it says of
  /// itself.
  static Result<std::unique_ptr<GlRenderer>> create();
  ~GlRenderer();
  GlRenderer(const GlRenderer&) = delete;
  GlRenderer& operator=(const GlRenderer&) = delete;

  /// May be called for every frame: what the last frame still draws from is not waited for.
  void setMesh(const PaperMesh& mesh);
  /// One for each facet, or empty: none.
  void setTints(const std::vector<TintColor>& tints);
  /// Colours, textures, widths of lines (mm as on a screen of 96 dots an inch, whatever the scale
  /// of the view), their style. What GlView says too is not looked at.
  void setAppearance(const Appearance& appearance);

  /// Clears the framebuffer and draws. Needs a depth buffer, depth range and clear depth as in a
  /// new context; looks best with 4 samples. Leaves the context as it is at first in what it
  /// changes (depth test, blending, masks, scissor test, program, vertex array, buffers and
  /// textures of units 0 to 2, unit 0 active), but for the viewport, the clear colour, culling, and
  /// the sRGB conversion of the framebuffer, which is off.
  void draw(const GlView& view);

  /// What draws: "OpenGL 4.5, llvmpipe".
  std::string description() const;

 private:
  struct Gpu;
  explicit GlRenderer(std::unique_ptr<Gpu> gpu);
  std::unique_ptr<Gpu> gpu_;
};

}  // namespace kiri
