// The crease pattern as SVG for other origami programs and for machines (docs/formats/svg.md).
// SPDX-License-Identifier: MIT
#include "io/svg_pattern_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/paper/contours.h"
#include "io/json_tree.h"
#include "io/svg_looks.h"

namespace kiri {

namespace {

/// Millimetres with as many digits as a machine can use, and no more.
std::string mm(double value) {
  constexpr double kParts = 1e6;
  return numberText(std::round(value * kParts) / kParts);
}

class SvgPattern {
 public:
  SvgPattern(const FoldedState& state, const SvgPatternOptions& options)
      : state_(state), pattern_(state.pattern), options_(options) {
    bool isFirst = true;
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      if (!isUsed(EdgeId(e))) continue;
      const Box box = boundsOf(arcOf(pattern_, EdgeId(e)));
      box_ = isFirst ? box
                     : Box{{std::min(box_.low.x, box.low.x), std::min(box_.low.y, box.low.y)},
                           {std::max(box_.high.x, box.high.x), std::max(box_.high.y, box.high.y)}};
      isFirst = false;
    }
  }

  std::string text() {
    const double width = box_.high.x - box_.low.x + 2 * options_.margin;
    const double height = box_.high.y - box_.low.y + 2 * options_.margin;
    out_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "width=\"" +
        mm(width) + "mm\" height=\"" + mm(height) + "mm\" viewBox=\"0 0 " + mm(width) + " " +
        mm(height) + "\" fill=\"none\" stroke-width=\"" + mm(options_.strokeWidth) +
        "\" stroke-linecap=\"round\">\n";
    if (!options_.title.empty()) out_ += "  <title>" + xmlText(options_.title) + "</title>\n";
    writeCuts();
    writeScores();
    return out_ + "</svg>\n";
  }

 private:
  bool isUsed(EdgeId e) const { return pattern_[e].left.isValid() || pattern_[e].right.isValid(); }

  std::string at(Vec2 p) const {
    return mm(p.x - box_.low.x + options_.margin) + " " + mm(box_.high.y - p.y + options_.margin);
  }

  std::string onward(const Arc& arc) const {
    if (!arc.isCurved) return " L" + at(arc.end);
    return " C" + at(arc.control1) + " " + at(arc.control2) + " " + at(arc.end);
  }

  void path(const std::string& d, char assignment, double angle, const std::string& more = "") {
    out_ += "    <path d=\"" + d + "\" data-assignment=\"" + std::string(1, assignment) +
            "\" data-foldAngle=\"" + numberText(angle) + "\"" + more + "/>\n";
  }

  void open(char letter) { out_ += svgGroupTag(svgLineLook(letter), options_.strokeWidth); }

  void close() { out_ += "  </g>\n"; }

  void writeCuts() {
    open('B');
    for (const std::vector<EdgeUse>& chain : contoursOf(pattern_)) {
      std::string d = "M" + at(arcOf(pattern_, chain.front()).start);
      for (const EdgeUse use : chain) d += onward(arcOf(pattern_, use));
      path(d + " Z", 'B', 0);
    }
    close();
    open('C');
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      const EdgeKind kind = pattern_.edges[e].kind;
      if (kind != EdgeKind::Tear && kind != EdgeKind::Cut) continue;
      const Arc arc = arcOf(pattern_, EdgeId(e));
      path("M" + at(arc.start) + onward(arc), 'C', 0);
    }
    close();
  }

  void writeScores() {
    for (const char letter : {'M', 'V', 'F'}) writeHinges(letter);
  }

  void writeHinges(char letter) {
    open(letter);
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      const Edge& edge = pattern_.edges[e];
      if (edge.kind != EdgeKind::Hinge) continue;
      const char own = edge.angle > 0 ? 'V' : edge.angle < 0 ? 'M' : 'F';
      if (own != letter) continue;
      constexpr double kFoldedFlat = 180;
      const double part = std::fabs(edge.angle) / kFoldedFlat;
      // Programs that read colours take the target angle from the opacity.
      std::string more;
      if (part > 0 && part < 1) more += " stroke-opacity=\"" + mm(part) + "\"";
      if (edge.line.isValid()) {
        more += " data-fold=\"" + xmlText(state_.lines[edge.line.index].name) + "\"";
      }
      const Arc arc = arcOf(pattern_, EdgeId(e));
      path("M" + at(arc.start) + onward(arc), letter, edge.angle, more);
    }
    close();
  }

  const FoldedState& state_;
  const CreasePattern& pattern_;
  SvgPatternOptions options_;
  Box box_{{0, 0}, {0, 0}};
  std::string out_;
};

}  // namespace

std::string writeSvgPattern(const FoldedState& state, const SvgPatternOptions& options) {
  return SvgPattern(state, options).text();
}

}  // namespace kiri
