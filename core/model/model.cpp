// SPDX-License-Identifier: MIT
#include "core/model/model.h"

namespace kiri {

bool SheetSpec::operator==(const SheetSpec& other) const {
  if (shape != other.shape || unknown != other.unknown) return false;
  if (shape == Shape::Polygon) return outline == other.outline && holes == other.holes;
  return width == other.width && (shape != Shape::Rectangle || height == other.height);
}

Result<Sheet> makeSheet(const SheetSpec& spec) {
  switch (spec.shape) {
    case SheetSpec::Shape::Square:
      return squareSheet(spec.width);
    case SheetSpec::Shape::Rectangle:
      return rectangleSheet(spec.width, spec.height);
    case SheetSpec::Shape::Disc:
      return discSheet(spec.width / 2);
    case SheetSpec::Shape::Polygon:
      return polygonSheet(spec.outline, spec.holes);
  }
  KIRI_CHECK(false, "every shape of sheet is known");
}

}  // namespace kiri
