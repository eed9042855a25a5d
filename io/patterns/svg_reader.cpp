// Crease patterns drawn as SVG (docs/formats/svg.md).
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "io/patterns/svg_document.h"
#include "io/patterns/svg_walk.h"

namespace kiri {

namespace {

/// Curves become lines no farther from them than this part of the drawing's diagonal.
constexpr double kCurvesWithin = 1.0 / 2000;
constexpr std::size_t kMostLines = 1'000'000;

Vec2 mirrored(Vec2 p) { return {p.x, p.y == 0 ? 0 : -p.y}; }

class BoxOfPoints {
 public:
  void add(const Arc& arc) {
    const Box box = boundsOf(arc);
    box_ = isEmpty_ ? box : joined(box_, box);
    isEmpty_ = false;
  }
  bool isEmpty() const { return isEmpty_; }
  const Box& box() const { return box_; }
  double diagonal() const { return isEmpty_ ? 0 : distance(box_.low, box_.high); }

 private:
  Box box_;
  bool isEmpty_ = true;
};

/// The corners of a chain once its curves are lines, from its start to its end.
std::vector<Vec2> cornersOf(const SvgChain& chain, double within) {
  std::vector<Vec2> corners{chain.arcs.front().start};
  for (const Arc& arc : chain.arcs) {
    if (corners.size() > kMostLines) break;  // the caller refuses it
    if (arc.start != corners.back()) corners.push_back(arc.start);
    if (!arc.isCurved || !(within > 0)) {
      corners.push_back(arc.end);
      continue;
    }
    const std::vector<double> parameters = flatteningParameters(arc, within);
    for (std::size_t i = 1; i + 1 < parameters.size(); ++i) {
      corners.push_back(pointAt(arc, parameters[i]));
    }
    corners.push_back(arc.end);
  }
  return corners;
}

std::string countedParts(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

const char* wordFor(Assignment assignment) {
  constexpr std::array<const char*, 7> kWords{"border",     "mountain", "valley", "flat",
                                              "unassigned", "cut",      "join"};
  return kWords[static_cast<std::size_t>(assignment)];
}

/// Makes the drawing from what was found, and says what became of the rest.
class SvgPatternMaker {
 public:
  SvgPatternMaker(SvgContents contents, std::string fileName)
      : contents_(std::move(contents)), fileName_(std::move(fileName)) {
    for (const SvgDrawn& drawn : contents_.drawn) {
      for (const Arc& arc : drawn.chain.arcs) lines_.add(arc);
    }
    within_ = lines_.diagonal() * kCurvesWithin;
  }

  Result<PatternFile> make(const SvgDocument& document, const SvgHead& head) {
    file_.format = PatternFormat::Svg;
    file_.title = head.title;
    file_.author = head.author;
    file_.description = head.description;
    file_.mmPerUnit = head.mmPerUnit;
    if (contents_.drawn.empty()) return noLines();
    for (const SvgDrawn& drawn : contents_.drawn) {
      addLines(drawn);
      if (file_.drawing.lines.size() > kMostLines) {
        return Error{ErrorCode::BadFile,
                     fileName_ +
                         ": more than a million lines once curves are flattened; this is "
                         "no crease pattern that can be folded"};
      }
    }
    if (!document.brokenAt.empty()) {
      note("the file breaks off or is damaged at " + document.brokenAt +
           "; what comes before was read");
    }
    if (document.styles->leftOut() > 0) {
      note(countedParts(document.styles->leftOut(), "style rule was", "style rules were") +
           " left out: only selectors of element, class and id are understood");
    }
    tellLines();
    tellFilled();
    tellLeftOut();
    return std::move(file_);
  }

 private:
  void note(std::string sentence) { file_.notes.push_back(std::move(sentence)); }
  void noteCount(std::size_t count, const std::string& one, const std::string& many,
                 const std::string& what) {
    if (count > 0) note(countedParts(count, one, many) + " " + what);
  }

  Error noLines() const {
    const SvgCounts& c = contents_.counts;
    return Error{ErrorCode::BadFile,
                 fileName_ + ": the drawing has no lines to fold (" +
                     countedParts(c.filledOnly, "shape is", "shapes are") + " only filled, " +
                     countedParts(c.hidden, "is", "are") + " hidden, " +
                     countedParts(c.texts, "is", "are") + " text, " +
                     countedParts(c.images, "is an image", "are images") +
                     "); draw creases as strokes: mountains red, valleys blue, the border black"};
  }

  void addLines(const SvgDrawn& drawn) {
    const std::vector<Vec2> corners = cornersOf(drawn.chain, within_);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      file_.drawing.lines.push_back({mirrored(corners[i]), mirrored(corners[i + 1]),
                                     drawn.meaning.assignment, drawn.meaning.angle});
    }
    const auto curved =
        static_cast<std::size_t>(std::count_if(drawn.chain.arcs.begin(), drawn.chain.arcs.end(),
                                               [](const Arc& arc) { return arc.isCurved; }));
    curves_ += curved;
    if (curved > 0) pieces_ += corners.size() - 1 - (drawn.chain.arcs.size() - curved);
    if (drawn.meaning.isPartial) ++partial_;
    if (drawn.meaning.isContradicted) ++contradicted_;
    if (drawn.meaning.source == LineMeaning::Source::Nothing) ++uncoloured_;
    if (drawn.meaning.source == LineMeaning::Source::Named) ++named_;
    hasBorder_ = hasBorder_ || drawn.meaning.assignment == Assignment::Border;
  }

  void tellLines() {
    if (curves_ > 0) {
      note(countedParts(curves_, "curve", "curves") + " became " +
           countedParts(pieces_, "straight line", "straight lines") + ", nowhere farther than " +
           text(within_) + " units from it");
    }
    noteCount(partial_, "line folds", "lines fold",
              "part of the way, as the opacity says (opacity x 180 degrees)");
    noteCount(contradicted_, "line has", "lines have",
              "a data-foldAngle of the wrong sign; data-assignment was believed");
    tellColours();
    noteCount(named_, "line has no colour; its class says",
              "lines have no colour; their class says", "what it is");
    noteCount(uncoloured_, "line has", "lines have",
              "no colour; read as unassigned (give mountains red, valleys blue, borders black)");
  }

  void tellColours() {
    constexpr std::size_t kMostTold = 8;
    std::vector<std::pair<std::string, UnlistedColour>> colours(contents_.unlisted.begin(),
                                                                contents_.unlisted.end());
    std::stable_sort(colours.begin(), colours.end(),
                     [](const auto& a, const auto& b) { return a.second.count > b.second.count; });
    std::size_t rest = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const auto& [name, colour] = colours[i];
      if (i >= kMostTold) {
        rest += colour.count;
        continue;
      }
      note(countedParts(colour.count, "line", "lines") + " in " + name + " read as " +
           wordFor(colour.assignment) + ", whose colour is nearest");
    }
    noteCount(rest, "line", "lines", "in other colours read by the nearest colour");
  }

  /// Filled shapes are faces where nothing else says where the paper is.
  void tellFilled() {
    const std::size_t count = contents_.counts.filledOnly;
    if (count == 0) return;
    BoxOfPoints faces;
    for (const SvgChain& chain : contents_.filled) {
      for (const Arc& arc : chain.arcs) faces.add(arc);
    }
    // A background larger than the drawing is no paper.
    const double slack = lines_.diagonal() / 100;
    const bool isSame = !faces.isEmpty() && distance(faces.box().low, lines_.box().low) < slack &&
                        distance(faces.box().high, lines_.box().high) < slack;
    if (hasBorder_ || !isSame) {
      note(countedParts(count, "filled shape", "filled shapes") + " without a stroke left out");
      return;
    }
    for (const SvgChain& chain : contents_.filled) {
      std::vector<Vec2> corners = cornersOf(chain, within_);
      if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
      if (corners.size() < 3) continue;
      std::vector<Vec2>& face = file_.drawing.faces.emplace_back();
      for (const Vec2 p : corners) face.push_back(mirrored(p));
    }
    note("no line is a border: the paper is where " +
         countedParts(count, "filled shape without a stroke is",
                      "filled shapes without a stroke are"));
  }

  void tellLeftOut() {
    const SvgCounts& c = contents_.counts;
    noteCount(c.hidden, "hidden element", "hidden elements", "left out");
    noteCount(c.invisible, "shape", "shapes", "with neither stroke nor fill left out");
    noteCount(c.texts, "text", "texts", "left out");
    noteCount(c.images, "image", "images", "left out");
    noteCount(c.foreign, "foreign object", "foreign objects", "left out");
    noteCount(c.clipped, "element is", "elements are",
              "clipped or masked in the drawing; their lines were read whole");
    noteCount(c.lostUses, "copy", "copies", "(<use>) of what is not in the file left out");
    noteCount(c.tooDeep, "element", "elements", "left out: too many groups within each other");
    noteCount(c.damagedShapes, "shape has", "shapes have",
              "damaged data and were read up to the damage");
    noteCount(c.damagedTransforms, "transform", "transforms",
              "could not be read and were left out");
    noteCount(c.wildPlaces, "line", "lines", "with coordinates that are no numbers left out");
  }

  SvgContents contents_;
  std::string fileName_;
  PatternFile file_;
  BoxOfPoints lines_;
  double within_ = 0;
  bool hasBorder_ = false;
  std::size_t curves_ = 0;
  std::size_t pieces_ = 0;
  std::size_t partial_ = 0;
  std::size_t contradicted_ = 0;
  std::size_t uncoloured_ = 0;
  std::size_t named_ = 0;
};

}  // namespace

Result<PatternFile> readSvgPattern(std::string_view text, std::string_view fileName) {
  Result<SvgDocument> document = parseSvg(text, fileName);
  if (!document) return document.error();
  const SvgHead head = svgHeadOf(*document);
  Result<SvgContents> contents = svgContentsOf(*document, head, std::string(fileName));
  if (!contents) return contents.error();
  return SvgPatternMaker(std::move(*contents), std::string(fileName)).make(*document, head);
}

}  // namespace kiri
