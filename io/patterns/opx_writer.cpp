// Writing .opx files of ORIPA (docs/formats/opx.md).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "io/json_tree.h"
#include "io/patterns/losses.h"
#include "io/patterns/opx_format.h"
#include "io/svg_looks.h"

namespace kiri {

namespace {

int typeOfOpxLine(Assignment assignment) {
  switch (assignment) {
    case Assignment::Border:
    case Assignment::Cut:
      return 1;
    case Assignment::Mountain:
      return 2;
    case Assignment::Valley:
      return 3;
    case Assignment::Unassigned:
      return 4;
    case Assignment::Flat:
    case Assignment::Join:
      break;
  }
  return 0;
}

/// The text as XML content; a carriage return would become a line feed when it is read.
std::string inXml(std::string_view text) {
  std::string out;
  for (std::size_t at = text.find('\r'); at != std::string_view::npos; at = text.find('\r')) {
    out += xmlText(text.substr(0, at)) + "&#13;";
    text.remove_prefix(at + 1);
  }
  return out + xmlText(text);
}

/// <void property="x0"><double>1.5</double></void>; nothing for Java's default, 0.
void addProperty(std::string& out, const char* name, const char* type, double value) {
  if (value == 0) return;
  out += std::string("       <void property=\"") + name + "\">\n        <" + type + ">" +
         numberText(value) + "</" + type + ">\n       </void>\n";
}

void addOpxText(std::string& out, const char* name, const std::string& text) {
  if (text.empty()) return;
  out += std::string("  <void class=\"oripa.DataSet\" method=\"getField\">\n   <string>") + name +
         "</string>\n   <void method=\"set\">\n    <object idref=\"DataSet0\"/>\n    <string>" +
         inXml(text) + "</string>\n   </void>\n  </void>\n";
}

void addLines(std::string& out, const std::vector<DrawnCrease>& lines) {
  out +=
      "  <void class=\"oripa.DataSet\" method=\"getField\">\n   <string>lines</string>\n"
      "   <void method=\"set\">\n    <object idref=\"DataSet0\"/>\n"
      "    <array class=\"oripa.OriLineProxy\" length=\"" +
      std::to_string(lines.size()) + "\">\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out += "     <void index=\"" + std::to_string(i) +
           "\">\n      <object class=\"oripa.OriLineProxy\">\n";
    addProperty(out, "type", "int", typeOfOpxLine(lines[i].assignment));
    addProperty(out, "x0", "double", lines[i].from.x);
    addProperty(out, "x1", "double", lines[i].to.x);
    addProperty(out, "y0", "double", 0 - lines[i].from.y);
    addProperty(out, "y1", "double", 0 - lines[i].to.y);
    out += "      </object>\n     </void>\n";
  }
  out += "    </array>\n   </void>\n  </void>\n";
}

/// ORIPA's paper is a square around the origin of this width.
double paperSizeOf(const std::vector<DrawnCrease>& lines) {
  double reach = 0;
  for (const DrawnCrease& line : lines) {
    for (const Vec2 p : {line.from, line.to}) {
      reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
    }
  }
  return 2 * reach;
}

}  // namespace

WrittenPattern writeOpxPattern(const PatternFile& file) {
  WrittenPattern out;
  FormatRoom room;
  room.name = ".opx";
  room.hasFlat = room.hasUnassigned = room.hasTitle = room.hasAuthor = room.hasDescription = true;
  out.losses = lossesOf(file, room);
  out.text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<java version=\"1.8.0\" class=\"java.beans.XMLDecoder\">\n"
      " <object class=\"oripa.DataSet\" id=\"DataSet0\">\n";
  addOpxText(out.text, "memo", file.description);
  addLines(out.text, file.drawing.lines);
  addOpxText(out.text, "originalAuthorName", file.author);
  addOpxText(out.text, "title", file.title);
  out.text +=
      "  <void property=\"mainVersion\">\n   <int>1</int>\n  </void>\n"
      "  <void property=\"paperSize\">\n   <double>" +
      numberText(paperSizeOf(file.drawing.lines)) +
      "</double>\n  </void>\n"
      "  <void property=\"subVersion\">\n   <int>1</int>\n  </void>\n"
      " </object>\n</java>\n";
  return out;
}

}  // namespace kiri
