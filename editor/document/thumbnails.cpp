// SPDX-License-Identifier: MIT
#include "editor/document/thumbnails.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/paper/boxes.h"
#include "render/canvas/rasterise.h"
#include "render/scene/model_scene.h"
#include "render/scene/pattern_scene.h"

namespace kiri {
namespace {

/// mm of the scene for one pixel of the toolkit; widths of lines are given in them.
constexpr double kPixel = 1;
constexpr double kMargin = 2 * kPixel;
constexpr double kEdge = 1.1 * kPixel;
constexpr double kCrease = 0.7 * kPixel;
constexpr double kUsual = 96;  ///< pixels of a thumbnail on a plain screen

/// The part of the paper that lines may cover: where facets are smaller than a few pixels, lines in
/// full width would leave nothing but black.
constexpr double kMostInk = 0.35;

double areaOf(const std::vector<Loop>& loops) {
  double twice = 0;
  for (const Loop& loop : loops) {
    for (const Arc& arc : loop) twice += cross(arc.start, arc.end);
  }
  return std::abs(twice) / 2;
}

double inkOf(const StrokeItem& lines) {
  double length = 0;
  for (const std::vector<Arc>& chain : lines.chains) {
    for (const Arc& arc : chain) length += distance(arc.start, arc.end);
  }
  return length * lines.stroke.width;
}

/// The lines of an item; none when it is paper, or what closes the gaps between facets.
StrokeItem* linesOf(Item& item) {
  return item.kind == "seam" ? nullptr : std::get_if<StrokeItem>(&item.shape);
}

void spareInk(Scene& scene) {
  double paper = 0;
  double ink = 0;
  for (Group& group : scene.groups) {
    for (Item& item : group.items) {
      if (const FillItem* fill = std::get_if<FillItem>(&item.shape)) paper += areaOf(fill->loops);
      if (const StrokeItem* lines = linesOf(item)) ink += inkOf(*lines);
    }
  }
  if (ink <= kMostInk * paper || paper <= 0) return;
  const double part = kMostInk * paper / ink;
  for (Group& group : scene.groups) {
    for (Item& item : group.items) {
      if (StrokeItem* lines = linesOf(item)) lines->stroke.width *= part;
    }
  }
}

Error cancelled() { return {ErrorCode::Cancelled, "the picture was stopped", {}}; }

/// The model in a box of the view.
Result<Image> draw(const FoldedState& state, Appearance appearance, const ViewSpec& view,
                   const Box& box, int pixels, double density, const Progress& progress) {
  ModelSceneOptions options;
  options.box = box;
  options.margin = kMargin;
  options.progress = progress;
  const Vec2 size = box.high - box.low;
  const double room = std::max(1.0, pixels / density - 2 * kMargin);
  options.scale = room / std::max(size.x, size.y);
  appearance.isShaded = true;
  appearance.edgeWidth = kEdge;
  appearance.creaseWidth = kCrease;
  Result<Scene> scene = modelScene(state, appearance, view, options);
  if (!scene) return scene.error();
  if (!goesOn(progress, 0.5)) return cancelled();
  spareInk(*scene);
  return rasteriseTransparent(*scene, pixels, pixels);
}

}  // namespace

Result<Image> thumbnailOf(const FoldedState& state, Appearance appearance, int pixels,
                          double density, const Progress& progress) {
  if (!goesOn(progress, 0)) return cancelled();
  const ModelBox space = modelBoxOf(state);
  const Box box{flatten(space.low), flatten(space.high)};
  return draw(state, std::move(appearance), frontSpec(), box, pixels, density, progress);
}

Result<Image> thumbnailOf(const FoldedState& state, Appearance appearance, const ViewSpec& view,
                          int pixels, double density, const Progress& progress) {
  if (!goesOn(progress, 0)) return cancelled();
  const Result<Box> box = pictureBox(state, view);
  if (!box) return box.error();
  return draw(state, std::move(appearance), view, *box, pixels, density, progress);
}

Result<Image> thumbnailOf(const FoldedState& state, const Model& model, int pixels,
                          const Progress& progress) {
  const double density = std::max(1.0, pixels / kUsual);
  return thumbnailOf(state, appearanceOf(model), pixels, density, progress);
}

Result<Image> patternThumbnail(const FoldedState& state, Appearance appearance, int pixels,
                               double density) {
  PatternSceneOptions options;
  options.margin = 0;
  const Scene plain = patternScene(state, appearance, options);
  options.margin = kMargin;
  const double room = std::max(1.0, pixels / density - 2 * kMargin);
  options.scale = room / std::max(plain.width, plain.height);
  appearance.edgeWidth = kEdge;
  appearance.creaseWidth = kCrease;
  Scene scene = patternScene(state, appearance, options);
  spareInk(scene);
  return rasteriseTransparent(scene, pixels, pixels);
}

}  // namespace kiri
