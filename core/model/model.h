// A model: a sheet and a list of steps. Nothing else is saved (DESIGN section 2).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/model/step.h"
#include "core/paper/sheet.h"

namespace kiri {

/// sRGB, 0 to 255.
struct Color {
  std::uint8_t red = 255;
  std::uint8_t green = 255;
  std::uint8_t blue = 255;
  constexpr bool operator==(const Color&) const = default;
};

/// How one side of the paper looks. The texture, where there is one, covers the box of the sheet.
struct PaperSide {
  Color color;
  std::string texture;  ///< path of a PNG image, relative to the model's file; empty: none
  bool operator==(const PaperSide&) const = default;
};

/// What was written about the sheet, kept so that a file is saved as it was read.
struct SheetSpec {
  enum class Shape { Square, Rectangle, Disc, Polygon };
  Shape shape = Shape::Square;
  double width = 150;   ///< side of the square, width of the rectangle, diameter of the disc; mm
  double height = 150;  ///< rectangle only
  std::vector<Vec2> outline;             ///< polygon only
  std::vector<std::vector<Vec2>> holes;  ///< polygon only
  std::string unknown;                   ///< fields that the reader did not know, as JSON text
  /// Compares what the shape makes use of.
  bool operator==(const SheetSpec& other) const;
};

struct Model {
  std::string title;
  std::string notes;
  SheetSpec sheet;
  PaperSide front{{90, 140, 70}, ""};
  PaperSide back{{214, 226, 190}, ""};
  Sequence opening = Sequence::InOrder;  ///< how all of it unfolds at once (thesis 4.5 B17)
  std::vector<Step> steps;
  std::string unknown;  ///< fields that the reader did not know, as JSON text
  bool operator==(const Model&) const = default;
};

/// The sheet that a description means. Errors: BadValue, see sheet.h.
Result<Sheet> makeSheet(const SheetSpec& spec);

}  // namespace kiri
