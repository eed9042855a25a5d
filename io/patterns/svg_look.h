// How an element of an SVG drawing looks, and what that makes of its lines.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "core/creases/crease_drawing.h"
#include "io/patterns/svg_colour.h"
#include "io/patterns/svg_style.h"

namespace pugi {
class xml_node;
}

namespace kiri {

/// What an element has from its ancestors and itself.
struct SvgLook {
  std::optional<SvgColour> stroke;
  bool hasStroke = false;  ///< somebody said something about the stroke, "none" perhaps
  double strokeOpacity = 1;
  double opacity = 1;  ///< of the element and all around it
  bool isFilled = true;
  bool isVisible = true;
  bool isDisplayed = true;
  SvgColour current;                 ///< what currentColor means
  std::optional<Assignment> stated;  ///< data-assignment
  std::optional<double> angle;       ///< data-foldAngle, degrees
  std::optional<Assignment> named;   ///< a class like "mountain"
};

/// The look of an element within something that looks like `around`.
SvgLook svgLookOf(const pugi::xml_node& element, const SvgValues& values, const SvgLook& around);

/// What a line of that look is.
struct LineMeaning {
  enum class Source {
    Stated,   ///< data-assignment, or the sign of data-foldAngle
    Colour,   ///< a colour that means just this
    Nearest,  ///< the colour comes nearest to one that means this
    Named,    ///< no colour, but a class says it
    Nothing,  ///< neither: unassigned
  };
  Assignment assignment = Assignment::Unassigned;
  std::optional<double> angle;
  Source source = Source::Nothing;
  bool isPartial = false;       ///< the angle is what the opacity says
  bool isContradicted = false;  ///< data-foldAngle had the sign of the other assignment
};
LineMeaning meaningOf(const SvgLook& look);

}  // namespace kiri
