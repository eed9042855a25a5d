// SPDX-License-Identifier: MIT
#include "editor/document/new_sheet.h"

#include <cmath>

#include "core/base/text.h"

namespace kiri {
namespace {

/// Coloured in front and pale behind, as folding paper is sold.
Model onPaper(SheetSpec sheet) {
  Model model;
  model.sheet = std::move(sheet);
  model.front.color = {190, 62, 48};
  model.back.color = {250, 244, 230};
  return model;
}

SheetSpec rectangle(double width, double height) {
  SheetSpec sheet;
  sheet.shape = width == height ? SheetSpec::Shape::Square : SheetSpec::Shape::Rectangle;
  sheet.width = width;
  sheet.height = height;
  return sheet;
}

SheetSpec disc(double diameter) {
  SheetSpec sheet;
  sheet.shape = SheetSpec::Shape::Disc;
  sheet.width = diameter;
  return sheet;
}

/// The right border of a leaf of height 1 and width 1 at the height t: pointed at both ends, widest
/// below the middle.
double halfWidthAt(double t) { return 2 * t * (1 - t) * (1.3 - 0.6 * t); }

/// Upright, symmetric about its middle line, which goes through two of its corners.
SheetSpec leaf(double width, double height) {
  constexpr int kParts = 40;
  const auto rounded = [](double mm) { return std::round(mm * 10) / 10; };
  SheetSpec sheet;
  sheet.shape = SheetSpec::Shape::Polygon;
  const double middle = width / 2;
  for (int i = 0; i <= kParts; ++i) {
    const double t = static_cast<double>(i) / kParts;
    sheet.outline.push_back({middle + rounded(width * halfWidthAt(t)), rounded(height * t)});
  }
  for (int i = kParts - 1; i > 0; --i) {
    const Vec2 right = sheet.outline[static_cast<std::size_t>(i)];
    sheet.outline.push_back({width - right.x, right.y});
  }
  return sheet;
}

Phrase sizeOf(double width, double height) {
  return {KIRI_TEXT("editor/document", "%1 × %2 mm"), {text(width), text(height)}};
}

}  // namespace

std::vector<SheetPreset> sheetPresets() {
  constexpr double kSide = 150;
  std::vector<SheetPreset> presets;
  presets.push_back({"square",
                     {KIRI_TEXT("editor/document", "Square"), {}},
                     sizeOf(kSide, kSide),
                     onPaper(rectangle(kSide, kSide))});
  Model leafModel;  // in the greens that models have by default
  leafModel.sheet = leaf(110, 160);
  leafModel.opening = Sequence::Together;
  presets.push_back(
      {"leaf", {KIRI_TEXT("editor/document", "Leaf"), {}}, sizeOf(110, 160), std::move(leafModel)});
  presets.push_back({"disc",
                     {KIRI_TEXT("editor/document", "Disc"), {}},
                     {KIRI_TEXT("editor/document", "%1 mm across"), {text(kSide)}},
                     onPaper(disc(kSide))});
  presets.push_back({"a4",
                     {KIRI_TEXT("editor/document", "A4"), {}},
                     sizeOf(210, 297),
                     onPaper(rectangle(210, 297))});
  return presets;
}

Result<Model> rectangleModel(double width, double height) {
  for (const double side : {width, height}) {
    if (side >= kSmallestSheet && side <= kLargestSheet) continue;
    return Error{ErrorCode::BadValue,
                 "a side of the sheet must measure " + text(kSmallestSheet) + " to " +
                     text(kLargestSheet) + " mm, not " + text(side),
                 {}};
  }
  return onPaper(rectangle(width, height));
}

}  // namespace kiri
