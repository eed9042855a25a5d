// SPDX-License-Identifier: MIT
#include "editor/document/thumbnails.h"

#include <algorithm>

#include "core/paper/boxes.h"
#include "render/canvas/rasterise.h"
#include "render/scene/model_scene.h"

namespace kiri {
namespace {

/// mm of the scene for one pixel of the toolkit; widths of lines are given in them.
constexpr double kPixel = 1;
constexpr double kMargin = 2 * kPixel;
constexpr double kEdge = 1.1 * kPixel;
constexpr double kCrease = 0.7 * kPixel;
constexpr double kUsual = 96;  ///< pixels of a thumbnail on a plain screen

Error cancelled() { return {ErrorCode::Cancelled, "the picture was stopped", {}}; }

}  // namespace

Result<Image> thumbnailOf(const FoldedState& state, Appearance appearance, int pixels,
                          double density, const Progress& progress) {
  if (!goesOn(progress, 0)) return cancelled();
  const ModelBox space = modelBoxOf(state);
  ModelSceneOptions options;
  options.box = Box{flatten(space.low), flatten(space.high)};
  options.margin = kMargin;
  options.progress = progress;
  const Vec2 size = options.box->high - options.box->low;
  const double room = std::max(1.0, pixels / density - 2 * kMargin);
  options.scale = room / std::max(size.x, size.y);
  appearance.isShaded = true;
  appearance.edgeWidth = kEdge;
  appearance.creaseWidth = kCrease;
  const Result<Scene> scene = modelScene(state, appearance, frontSpec(), options);
  if (!scene) return scene.error();
  if (!goesOn(progress, 0.5)) return cancelled();
  return rasteriseTransparent(*scene, pixels, pixels);
}

Result<Image> thumbnailOf(const FoldedState& state, const Model& model, int pixels,
                          const Progress& progress) {
  const double density = std::max(1.0, pixels / kUsual);
  return thumbnailOf(state, appearanceOf(model), pixels, density, progress);
}

}  // namespace kiri
