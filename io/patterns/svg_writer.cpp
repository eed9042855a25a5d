// Crease patterns as SVG for other origami programs (docs/formats/svg.md).
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_writer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "core/geometry/cubic.h"
#include "io/json_tree.h"
#include "io/patterns/losses.h"
#include "io/svg_looks.h"

namespace kiri {

namespace {

char svgLetterOf(Assignment assignment) {
  constexpr std::string_view kLetters = "BMVFUCJ";
  return kLetters[static_cast<std::size_t>(assignment)];
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

std::string attribute(const char* name, double value) { return attribute(name, numberText(value)); }

/// y of the page: down, and never a zero with a sign.
double down(double y) { return y == 0 ? 0 : -y; }

Box boxOf(const CreaseDrawing& drawing) {
  Box box{{0, 0}, {1, 1}};
  bool isEmpty = true;
  for (const DrawnCrease& line : drawing.lines) {
    const Box own = boundsOf(Arc::line(line.from, line.to));
    box = isEmpty ? own : joined(box, own);
    isEmpty = false;
  }
  return box;
}

class SvgDrawing {
 public:
  explicit SvgDrawing(const PatternFile& file) : file_(file), box_(boxOf(file.drawing)) {
    const Vec2 size = box_.high - box_.low;
    const double larger = std::max(size.x, size.y);
    strokeWidth_ = larger > 0 ? larger / 400 : 1;
  }

  std::string text() {
    head();
    for (const SvgLineLook& look : kSvgLineLooks) group(look);
    return out_ + "</svg>\n";
  }

 private:
  void head() {
    // Room for the strokes of the border: nothing lies outside the page.
    const double margin = 4 * strokeWidth_;
    const Vec2 size = box_.high - box_.low + Vec2{2 * margin, 2 * margin};
    out_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    if (file_.mmPerUnit) {
      out_ += attribute("width", numberText(size.x * *file_.mmPerUnit) + "mm") +
              attribute("height", numberText(size.y * *file_.mmPerUnit) + "mm");
    }
    out_ += attribute("viewBox", numberText(box_.low.x - margin) + " " +
                                     numberText(down(box_.high.y) - margin) + " " +
                                     numberText(size.x) + " " + numberText(size.y)) +
            attribute("fill", "none") + attribute("stroke-width", strokeWidth_) +
            attribute("stroke-linecap", "round") + ">\n";
    if (!file_.title.empty()) out_ += "  <title>" + xmlText(file_.title) + "</title>\n";
    if (!file_.description.empty()) out_ += "  <desc>" + xmlText(file_.description) + "</desc>\n";
    if (!file_.author.empty()) {
      out_ += "  <metadata><dc:creator xmlns:dc=\"http://purl.org/dc/elements/1.1/\">" +
              xmlText(file_.author) + "</dc:creator></metadata>\n";
    }
  }

  void group(const SvgLineLook& look) {
    bool isOpen = false;
    for (const DrawnCrease& line : file_.drawing.lines) {
      if (svgLetterOf(line.assignment) != look.letter) continue;
      if (!isOpen) out_ += svgGroupTag(look, strokeWidth_);
      isOpen = true;
      add(line, look.letter);
    }
    if (isOpen) out_ += "  </g>\n";
  }

  void add(const DrawnCrease& line, char letter) {
    out_ += "    <line" + attribute("x1", line.from.x) + attribute("y1", down(line.from.y)) +
            attribute("x2", line.to.x) + attribute("y2", down(line.to.y)) +
            attribute("data-assignment", std::string(1, letter));
    if (line.angle) {
      out_ += attribute("data-foldAngle", *line.angle);
      const double part = std::fabs(*line.angle) / 180;
      if (part < 1 && (letter == 'M' || letter == 'V')) out_ += attribute("stroke-opacity", part);
    }
    out_ += "/>\n";
  }

  const PatternFile& file_;
  Box box_;
  double strokeWidth_ = 1;
  std::string out_;
};

}  // namespace

WrittenPattern writeSvgDrawing(const PatternFile& file) {
  FormatRoom room;
  room.name = "SVG";
  room.hasAngles = room.hasFlat = room.hasUnassigned = room.hasCuts = room.hasJoins = true;
  room.hasTitle = room.hasAuthor = room.hasDescription = room.hasUnit = true;
  return {SvgDrawing(file).text(), lossesOf(file, room)};
}

}  // namespace kiri
