// The sheet and the look of the paper as they stand in a .kiri file.
// SPDX-License-Identifier: MIT
#include "io/sheet_json.h"

#include <optional>
#include <string>
#include <vector>

#include "io/places_json.h"

namespace kiri {

namespace {

const std::vector<std::string>& shapeNames() {
  static const std::vector<std::string> names = {"square", "rectangle", "disc", "polygon"};
  return names;
}

double readLength(Fields& fields, const char* name, const char* meaning) {
  const std::optional<Field> field = fields.require(name, meaning);
  return field ? field->number({0, kLargestLength, true}) : 1;
}

void readPolygon(Fields& fields, SheetSpec& sheet) {
  if (const std::optional<Field> outline =
          fields.require("outline", "the corners of the sheet in mm, [[x, y], ...]")) {
    sheet.outline = outline->points(3);
  }
  const std::optional<Field> holes = fields.find("holes");
  if (!holes) return;
  if (!holes->isArray()) {
    holes->isNot("a list of holes, each a list of points [[x, y], ...]");
    return;
  }
  for (std::size_t i = 0; i < holes->size(); ++i) sheet.holes.push_back(holes->item(i).points(3));
}

/// Fields of another shape than the chosen one are a mistake in thought, not unknown.
void refuseOtherShapes(Fields& fields, const std::vector<std::string>& others,
                       const std::string& shape) {
  for (const std::string& name : others) {
    if (const std::optional<Field> field = fields.find(name)) {
      field->mistake("does not go with a " + shape + "; take it out or change \"shape\"");
    }
  }
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

Color readColor(const Field& field, Color fallback) {
  const std::optional<Color> color =
      field.isText() ? colorFromText(field.json().text) : std::nullopt;
  if (!color) field.isNot("a colour like \"#5a8c46\"");
  return color.value_or(fallback);
}

std::string colorText(Color color) {
  static const char* const digits = "0123456789abcdef";
  std::string out = "#";
  for (const std::uint8_t part : {color.red, color.green, color.blue}) {
    out += digits[part / 16];
    out += digits[part % 16];
  }
  return out;
}

void readSide(const Field& field, PaperSide& side) {
  Fields fields(field);
  if (const std::optional<Field> color = fields.find("color")) {
    side.color = readColor(*color, side.color);
  }
  side.texture = fields.text("texture");
  fields.finish();
}

JsonValue writeSide(const PaperSide& side) {
  JsonValue out = JsonValue::object();
  out.add("color", JsonValue::ofText(colorText(side.color)));
  if (!side.texture.empty()) out.add("texture", JsonValue::ofText(side.texture));
  return out;
}

}  // namespace

std::optional<Color> colorFromText(const std::string& text) {
  const bool isLong = text.size() == 7;
  const bool isShort = text.size() == 4;
  if (!(isLong || isShort) || text[0] != '#') return std::nullopt;
  int digits[6] = {};
  for (std::size_t i = 0; i < 6; ++i) {
    digits[i] = hexDigit(text[isLong ? 1 + i : 1 + i / 2]);
    if (digits[i] < 0) return std::nullopt;
  }
  const auto byte = [&](int i) {
    return static_cast<std::uint8_t>(16 * digits[i] + digits[i + 1]);
  };
  return Color{byte(0), byte(2), byte(4)};
}

SheetSpec readSheet(const Field& field) {
  SheetSpec sheet;
  Fields fields(field);
  const std::optional<Field> shape =
      fields.require("shape", "\"square\", \"rectangle\", \"disc\" or \"polygon\"");
  if (!shape) return sheet;
  sheet.shape = static_cast<SheetSpec::Shape>(shape->oneOf(shapeNames()));
  if (!field.findings().isGood()) return sheet;
  switch (sheet.shape) {
    case SheetSpec::Shape::Square:
      sheet.width = sheet.height = readLength(fields, "side", "the side of the square in mm");
      refuseOtherShapes(fields, {"width", "height", "diameter", "outline", "holes"}, "square");
      break;
    case SheetSpec::Shape::Rectangle:
      sheet.width = readLength(fields, "width", "in mm");
      sheet.height = readLength(fields, "height", "in mm");
      refuseOtherShapes(fields, {"side", "diameter", "outline", "holes"}, "rectangle");
      break;
    case SheetSpec::Shape::Disc:
      sheet.width = sheet.height = readLength(fields, "diameter", "of the disc in mm");
      refuseOtherShapes(fields, {"side", "width", "height", "outline", "holes"}, "disc");
      break;
    case SheetSpec::Shape::Polygon:
      readPolygon(fields, sheet);
      refuseOtherShapes(fields, {"side", "width", "height", "diameter"}, "polygon");
      break;
  }
  fields.finish();
  sheet.unknown = field.findings().takeUnknown();
  return sheet;
}

JsonValue writeSheet(const SheetSpec& sheet) {
  JsonValue out = JsonValue::object();
  out.add("shape", JsonValue::ofText(shapeNames()[static_cast<std::size_t>(sheet.shape)]));
  switch (sheet.shape) {
    case SheetSpec::Shape::Square:
      out.add("side", JsonValue::ofNumber(sheet.width));
      break;
    case SheetSpec::Shape::Rectangle:
      out.add("width", JsonValue::ofNumber(sheet.width));
      out.add("height", JsonValue::ofNumber(sheet.height));
      break;
    case SheetSpec::Shape::Disc:
      out.add("diameter", JsonValue::ofNumber(sheet.width));
      break;
    case SheetSpec::Shape::Polygon:
      out.add("outline", writePoints(sheet.outline));
      if (!sheet.holes.empty()) {
        JsonValue& holes = out.add("holes", JsonValue::array());
        for (const std::vector<Vec2>& hole : sheet.holes) holes.items.push_back(writePoints(hole));
      }
      break;
  }
  mergeUnknown(out, sheet.unknown);
  return out;
}

void readPaper(const Field& field, Model& model) {
  Fields fields(field);
  if (const std::optional<Field> front = fields.find("front")) readSide(*front, model.front);
  if (const std::optional<Field> back = fields.find("back")) readSide(*back, model.back);
  fields.finish();
}

JsonValue writePaper(const Model& model) {
  JsonValue out = JsonValue::object();
  out.add("front", writeSide(model.front));
  out.add("back", writeSide(model.back));
  return out;
}

}  // namespace kiri
