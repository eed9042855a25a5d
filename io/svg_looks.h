// How lines look in the SVG files that are written for origami programs and machines.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace kiri {

/// A group of lines. Colours are those that Origami Simulator, Rabbit Ear and Flat-Folder agree on;
/// dashes tell lines apart in black and white.
struct SvgLineLook {
  char letter;                   ///< of FOLD: B, C, M, V, F, U, J
  const char* id;                ///< of the group; machines look for Cut and Score
  const char* label;             ///< for people
  const char* colour;            ///< "#rrggbb"
  std::array<double, 4> dashes;  ///< as multiples of a stroke of 1; zeros: solid
};

/// All of them, in the order in which they are drawn.
inline constexpr std::array<SvgLineLook, 7> kSvgLineLooks{{
    {'B', "Cut", "border of the paper", "#000000", {}},
    {'C', "Cut-open", "tears, and cuts with paper on both sides", "#00ff00", {}},
    {'M', "Score-mountain", "mountain folds", "#ff0000", {16, 4, 2, 4}},
    {'V', "Score-valley", "valley folds", "#0000ff", {10, 6}},
    {'F', "Score-flat", "creases that lie flat", "#808080", {2, 4}},
    {'U', "Score-unassigned", "creases without a direction", "#ff00ff", {}},
    {'J', "Join", "lines that are no creases", "#ffff00", {}},
}};
/// Requires one of the letters.
const SvgLineLook& svgLineLook(char letter);

/// A tag "<g ...>" for lines of that look `strokeWidth` wide, indented by two, with its line break.
std::string svgGroupTag(const SvgLineLook& look, double strokeWidth);

/// Text as XML holds it: marks escaped, control characters left out.
std::string xmlText(std::string_view text);

}  // namespace kiri
