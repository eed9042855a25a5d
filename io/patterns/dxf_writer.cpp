// Writing DXF (docs/formats/dxf.md).
// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <utility>

#include "io/json_tree.h"
#include "io/patterns/dxf_format.h"
#include "io/patterns/dxf_layers.h"
#include "io/patterns/dxf_units.h"
#include "io/patterns/losses.h"

namespace kiri {

namespace {

void addPair(std::string& out, int code, const std::string& value) {
  const std::string number = std::to_string(code);
  out += std::string(number.size() < 3 ? 3 - number.size() : 0, ' ') + number + "\n" + value + "\n";
}

void addNumber(std::string& out, int code, double value) { addPair(out, code, numberText(value)); }

void addHeader(std::string& out, int units) {
  addPair(out, 0, "SECTION");
  addPair(out, 2, "HEADER");
  addPair(out, 9, "$ACADVER");
  addPair(out, 1, "AC1009");
  addPair(out, 9, "$INSUNITS");
  addPair(out, 70, std::to_string(units));
  addPair(out, 0, "ENDSEC");
}

void addLayerTable(std::string& out) {
  addPair(out, 0, "SECTION");
  addPair(out, 2, "TABLES");
  addPair(out, 0, "TABLE");
  addPair(out, 2, "LAYER");
  addPair(out, 70, std::to_string(kDxfLayers.size()));
  for (const DxfLayer& layer : kDxfLayers) {
    addPair(out, 0, "LAYER");
    addPair(out, 2, layer.name);
    addPair(out, 70, "0");
    addPair(out, 62, std::to_string(layer.colour));
    addPair(out, 6, "CONTINUOUS");
  }
  addPair(out, 0, "ENDTAB");
  addPair(out, 0, "ENDSEC");
}

}  // namespace

WrittenPattern writeDxfPattern(const PatternFile& file) {
  WrittenPattern out;
  const int units = file.mmPerUnit ? dxfUnitOf(*file.mmPerUnit) : kDxfUnitless;
  FormatRoom room;
  room.name = "DXF";
  room.hasFlat = room.hasUnassigned = room.hasCuts = room.hasJoins = true;
  room.hasUnit = !file.mmPerUnit || units != kDxfUnitless;
  out.losses = lossesOf(file, room);
  addHeader(out.text, units);
  addLayerTable(out.text);
  addPair(out.text, 0, "SECTION");
  addPair(out.text, 2, "ENTITIES");
  for (const DrawnCrease& line : file.drawing.lines) {
    const DxfLayer& layer = dxfLayerOf(line.assignment);
    addPair(out.text, 0, "LINE");
    addPair(out.text, 8, layer.name);
    addPair(out.text, 6, "CONTINUOUS");
    addPair(out.text, 62, std::to_string(layer.colour));
    addNumber(out.text, 10, line.from.x);
    addNumber(out.text, 20, line.from.y);
    addNumber(out.text, 11, line.to.x);
    addNumber(out.text, 21, line.to.y);
  }
  addPair(out.text, 0, "ENDSEC");
  addPair(out.text, 0, "EOF");
  return out;
}

}  // namespace kiri
