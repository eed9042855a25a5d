// All that an SVG drawing shows, in the coordinates of its root.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <string_view>
#include <utility>

#include "io/patterns/plain_number.h"

namespace kiri {

namespace {

constexpr int kDeepest = 200;                 // elements within each other
constexpr int kDeepestUse = 20;               // <use> within <use>
constexpr std::size_t kMostCopied = 500'000;  // elements shown through <use>
constexpr std::size_t kMostChains = 2'000'000;
constexpr std::size_t kMostArcs = 4'000'000;
constexpr std::size_t kMostEffort = 10'000'000;

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool fitsDrawing(const Arc& arc) {
  const auto fits = [](Vec2 p) { return isDrawable(p.x) && isDrawable(p.y); };
  return fits(arc.start) && fits(arc.end) &&
         (!arc.isCurved || (fits(arc.control1) && fits(arc.control2)));
}

Arc movedBy(const SvgMatrix& matrix, const Arc& arc) {
  return {matrix.apply(arc.start), matrix.apply(arc.end), arc.isCurved,
          arc.isCurved ? matrix.apply(arc.control1) : Vec2{},
          arc.isCurved ? matrix.apply(arc.control2) : Vec2{}};
}

class SvgWalk {
 public:
  SvgWalk(const SvgDocument& document, const SvgHead& head) : document_(document), head_(head) {}

  Result<SvgContents> walk(const std::string& fileName) {
    SvgMatrix root{1, 0, 0, head_.stretch, 0, 0};
    children(*document_.root, Place{root, lookOf(*document_.root, {}), 0, 0});
    if (isTooMuch()) {
      return Error{ErrorCode::BadFile,
                   fileName +
                       ": the drawing is too large to be a crease pattern once its copies (<use>) "
                       "and styles are worked out; save it with copies resolved and plain strokes"};
    }
    return std::move(out_);
  }

 private:
  struct Place {
    SvgMatrix matrix;
    SvgLook look;
    int depth = 0;
    int uses = 0;
  };

  bool isTooMuch() const {
    return copied_ > kMostCopied || effort_ > kMostEffort || arcs_ > kMostArcs ||
           out_.drawn.size() + out_.filled.size() > kMostChains;
  }

  SvgLook lookOf(const pugi::xml_node& element, const SvgLook& around) {
    return svgLookOf(element, document_.styles->valuesOf(element, effort_), around);
  }

  void children(const pugi::xml_node& element, const Place& place) {
    for (const pugi::xml_node& child : element.children()) {
      if (child.type() != pugi::node_element) continue;
      if (isTooMuch()) return;
      visit(child, place);
    }
  }

  void visit(const pugi::xml_node& element, const Place& around) {
    if (around.uses > 0) ++copied_;
    const std::string_view whole = element.name();
    const std::string_view name = localName(whole);
    // Elements of other programs have names like sodipodi:namedview.
    if (name.size() != whole.size() && whole.substr(0, 4) != "svg:") return;
    if (isOneOf(name, {"text", "flowRoot"})) {
      ++out_.counts.texts;
      return;
    }
    if (name == "image") ++out_.counts.images;
    if (name == "foreignObject") ++out_.counts.foreign;
    const bool isGroup = isOneOf(name, {"g", "a", "switch", "svg", "use"});
    const bool isShape =
        isOneOf(name, {"line", "rect", "polygon", "polyline", "path", "circle", "ellipse"});
    if (!isGroup && !isShape) return;
    if (around.depth >= kDeepest) {
      ++out_.counts.tooDeep;
      return;
    }
    Place place{around.matrix, lookOf(element, around.look), around.depth + 1, around.uses};
    if (!place.look.isDisplayed) {
      ++out_.counts.hidden;
      return;
    }
    if (element.attribute("clip-path") || element.attribute("mask")) ++out_.counts.clipped;
    place.matrix = compose(around.matrix, transformOf(element));
    if (isShape) {
      shape(element, name, place);
    } else if (name == "use") {
      use(element, place);
    } else if (name == "svg") {
      place.matrix = compose(place.matrix, nestedWindow(element));
      children(element, place);
    } else {
      children(element, place);
    }
  }

  SvgMatrix transformOf(const pugi::xml_node& element) {
    const pugi::xml_attribute attribute = element.attribute("transform");
    if (!attribute) return {};
    const std::optional<SvgMatrix> matrix = svgTransformOf(attribute.value());
    if (!matrix) ++out_.counts.damagedTransforms;
    return matrix.value_or(SvgMatrix{});
  }

  /// An attribute in user units; 0 when it is missing or no length.
  double lengthOf(const pugi::xml_node& element, const char* name, double whole) const {
    const char* text = element.attribute(name).value();
    if (*text == '\0') return 0;
    if (const std::optional<SvgLength> length = svgLengthOf(text)) return length->inUser(whole);
    // A number with a unit of another's making.
    std::string_view rest = text;
    return takeListed(rest).value_or(0);
  }
  double x(const pugi::xml_node& e, const char* name) const {
    return lengthOf(e, name, head_.size.x);
  }
  double y(const pugi::xml_node& e, const char* name) const {
    return lengthOf(e, name, head_.size.y);
  }
  double diagonal() const { return std::hypot(head_.size.x, head_.size.y) / std::sqrt(2.0); }

  Vec2 sizeOf(const pugi::xml_node& element, Vec2 otherwise) const {
    return {element.attribute("width") ? x(element, "width") : otherwise.x,
            element.attribute("height") ? y(element, "height") : otherwise.y};
  }

  SvgMatrix nestedWindow(const pugi::xml_node& element) const {
    return svgWindowMatrix(element, {x(element, "x"), y(element, "y")},
                           sizeOf(element, head_.size));
  }

  void use(const pugi::xml_node& element, Place place) {
    const std::optional<pugi::xml_node> target = document_.target(element);
    if (!target || place.uses >= kDeepestUse) {
      ++out_.counts.lostUses;
      return;
    }
    ++place.uses;
    place.matrix = compose(place.matrix, SvgMatrix{1, 0, 0, 1, x(element, "x"), y(element, "y")});
    if (localName(target->name()) != "symbol") {
      visit(*target, place);
      return;
    }
    ++copied_;
    place.look = lookOf(*target, place.look);
    place.matrix =
        compose(place.matrix, svgWindowMatrix(*target, {0, 0}, sizeOf(element, head_.size)));
    children(*target, place);
  }

  SvgOutline outlineOf(const pugi::xml_node& e, std::string_view name) const {
    if (name == "path") return svgPathOf(e.attribute("d").value());
    if (name == "polygon") return svgPointsOf(e.attribute("points").value(), true);
    if (name == "polyline") return svgPointsOf(e.attribute("points").value(), false);
    if (name == "line") {
      return {{{{Arc::line({x(e, "x1"), y(e, "y1")}, {x(e, "x2"), y(e, "y2")})}, false}}, true};
    }
    if (name == "rect") return rectangleOf(e);
    const Vec2 radii = name == "circle"
                           ? Vec2{lengthOf(e, "r", diagonal()), lengthOf(e, "r", diagonal())}
                           : Vec2{x(e, "rx"), y(e, "ry")};
    if (!(radii.x > 0) || !(radii.y > 0)) return {};
    return {{svgEllipse({x(e, "cx"), y(e, "cy")}, radii)}, true};
  }

  SvgOutline rectangleOf(const pugi::xml_node& e) const {
    const Vec2 size = sizeOf(e, {0, 0});
    if (!(size.x > 0) || !(size.y > 0)) return {};
    Vec2 radii{x(e, "rx"), y(e, "ry")};
    if (!e.attribute("rx")) radii.x = radii.y;
    if (!e.attribute("ry")) radii.y = radii.x;
    return {{svgRectangle({x(e, "x"), y(e, "y")}, size, radii)}, true};
  }

  void shape(const pugi::xml_node& element, std::string_view name, const Place& place) {
    if (!place.look.isVisible) {
      ++out_.counts.hidden;
      return;
    }
    const LineMeaning meaning = meaningOf(place.look);
    // A line has no inside: it is meant to be seen even where nobody gave it a colour.
    const bool isLine =
        meaning.source != LineMeaning::Source::Nothing || (name == "line" && !place.look.hasStroke);
    if (!isLine && !place.look.isFilled) {
      ++out_.counts.invisible;
      return;
    }
    if (!isLine) ++out_.counts.filledOnly;
    SvgOutline outline = outlineOf(element, name);
    if (!outline.isWhole) ++out_.counts.damagedShapes;
    for (SvgChain& chain : outline.chains) {
      if (!moveInto(place.matrix, chain)) continue;
      arcs_ += chain.arcs.size();
      if (isLine) {
        tellColour(place.look, meaning);
        out_.drawn.push_back({std::move(chain), meaning});
      } else if (chain.isClosed) {
        out_.filled.push_back(std::move(chain));
      }
    }
  }

  /// Moves a chain to root coordinates, without the arcs that no drawing can have; false when none
  /// is left.
  bool moveInto(const SvgMatrix& matrix, SvgChain& chain) {
    for (Arc& arc : chain.arcs) arc = movedBy(matrix, arc);
    const auto wild = std::remove_if(chain.arcs.begin(), chain.arcs.end(),
                                     [](const Arc& arc) { return !fitsDrawing(arc); });
    out_.counts.wildPlaces += static_cast<std::size_t>(chain.arcs.end() - wild);
    chain.arcs.erase(wild, chain.arcs.end());
    return !chain.arcs.empty();
  }

  void tellColour(const SvgLook& look, const LineMeaning& meaning) {
    if (meaning.source != LineMeaning::Source::Nearest) return;
    UnlistedColour& colour = out_.unlisted[hexOf(*look.stroke)];
    colour.assignment = meaning.assignment;
    ++colour.count;
  }

  const SvgDocument& document_;
  SvgHead head_;
  SvgContents out_;
  std::size_t copied_ = 0;
  std::size_t effort_ = 0;
  std::size_t arcs_ = 0;
};

}  // namespace

Result<SvgContents> svgContentsOf(const SvgDocument& document, const SvgHead& head,
                                  const std::string& fileName) {
  return SvgWalk(document, head).walk(fileName);
}

}  // namespace kiri
