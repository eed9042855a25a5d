// Colours in SVG, and what they mean in crease patterns.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/creases/crease_drawing.h"

namespace kiri {

/// 0 to 255 each; alpha 0 to 1.
struct SvgColour {
  double red = 0;
  double green = 0;
  double blue = 0;
  double alpha = 1;
};

/// A colour as CSS writes it: names, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla(),
/// numbers or percentages, commas or blanks. None for everything else ("none", "currentColor",
/// "url(#...)").
std::optional<SvgColour> svgColourOf(std::string_view text);

/// "#rrggbb", for sentences.
std::string hexOf(const SvgColour& colour);

/// What a line of that colour is: red mountain, blue valley, black border, green cut, yellow join,
/// magenta unassigned, grey flat (Origami Simulator, Rabbit Ear, Flat-Folder). Others by the
/// nearest of these - greys by how dark they are, colours by their hue, cyan being flat like the
/// auxiliary lines of Oriedita - and then `isExact` is false.
struct ColourMeaning {
  Assignment assignment = Assignment::Unassigned;
  bool isExact = true;
};
ColourMeaning meaningOf(const SvgColour& colour);

}  // namespace kiri
