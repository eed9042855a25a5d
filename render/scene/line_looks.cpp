// The strokes of the kinds of lines.
// SPDX-License-Identifier: MIT
#include "render/scene/line_looks.h"

namespace kiri {
namespace {

Stroke solid(Color color, double width) {
  Stroke stroke;
  stroke.color = color;
  stroke.width = width;
  return stroke;
}

Stroke dashed(Color color, double width, std::vector<double> dashes) {
  Stroke stroke = solid(color, width);
  stroke.dashes = std::move(dashes);
  // Round caps would fill the gaps of fine lines.
  stroke.cap = LineCap::Butt;
  for (double& dash : stroke.dashes) dash *= width;
  return stroke;
}

/// Colours of the thesis: mountain blue, valley red.
Stroke thesisStroke(LineKind kind, const Appearance& appearance, double width) {
  switch (kind) {
    case LineKind::Mountain:
      return solid({20, 60, 220}, width);
    case LineKind::Valley:
      return solid({220, 20, 20}, width);
    case LineKind::Flat:
      return solid(appearance.creaseColor, width);
    case LineKind::Border:
      return solid(appearance.edgeColor, width);
    case LineKind::Tear:
      return dashed({230, 110, 0}, width, {4, 2});
    case LineKind::Cut:
      return solid({230, 110, 0}, width);
  }
  return {};
}

/// Dashes after Yoshizawa and Randlett: valley dashed, mountain dash-dot-dot.
Stroke diagramStroke(LineKind kind, const Appearance& appearance, double width) {
  switch (kind) {
    case LineKind::Mountain:
      return dashed(appearance.edgeColor, width, {8, 3, 1.2, 3, 1.2, 3});
    case LineKind::Valley:
      return dashed(appearance.edgeColor, width, {7, 4});
    case LineKind::Flat:
      return solid(appearance.creaseColor, width / 2);
    case LineKind::Border:
      return solid(appearance.edgeColor, width);
    case LineKind::Tear:
      return dashed(appearance.edgeColor, width, {3, 3});
    case LineKind::Cut:
      return dashed(appearance.edgeColor, width * 1.5, {1.2, 1.8});
  }
  return {};
}

/// What origami programs read: mountain red, valley blue, cut green.
Stroke programStroke(LineKind kind, double width) {
  switch (kind) {
    case LineKind::Mountain:
      return solid({255, 0, 0}, width);
    case LineKind::Valley:
      return solid({0, 0, 255}, width);
    case LineKind::Flat:
      return solid({255, 255, 0}, width);
    case LineKind::Border:
      return solid({0, 0, 0}, width);
    case LineKind::Tear:
    case LineKind::Cut:
      return solid({0, 255, 0}, width);
  }
  return {};
}

/// Colours after Okabe and Ito (2002), apart in lightness too, and the dashes of diagrams.
Stroke safeStroke(LineKind kind, const Appearance& appearance, double width) {
  switch (kind) {
    case LineKind::Mountain:
      return dashed({0, 90, 200}, width, {8, 2, 1.2, 2, 1.2, 2});
    case LineKind::Valley:
      return dashed({240, 150, 0}, width, {6, 3});
    case LineKind::Flat:
      return solid(appearance.creaseColor, width / 2);
    case LineKind::Border:
      return solid(appearance.edgeColor, width);
    case LineKind::Tear:
      return dashed({120, 20, 80}, width, {3, 3});
    case LineKind::Cut:
      return solid({120, 20, 80}, width);
  }
  return {};
}

}  // namespace

const char* nameOf(LineKind kind) {
  switch (kind) {
    case LineKind::Mountain:
      return "mountain";
    case LineKind::Valley:
      return "valley";
    case LineKind::Flat:
      return "flat";
    case LineKind::Border:
      return "border";
    case LineKind::Tear:
      return "tear";
    case LineKind::Cut:
      return "cut";
  }
  return "";
}

Stroke strokeFor(LineKind kind, const Appearance& appearance, double width) {
  switch (appearance.lineStyle) {
    case LineStyle::Thesis:
      return thesisStroke(kind, appearance, width);
    case LineStyle::Diagram:
      return diagramStroke(kind, appearance, width);
    case LineStyle::Program:
      return programStroke(kind, width);
    case LineStyle::Safe:
      return safeStroke(kind, appearance, width);
  }
  return {};
}

Stroke edgeStroke(const Appearance& appearance) {
  return solid(appearance.edgeColor, appearance.edgeWidth);
}

Stroke creaseStroke(const Appearance& appearance) {
  return solid(appearance.creaseColor, appearance.creaseWidth);
}

}  // namespace kiri
