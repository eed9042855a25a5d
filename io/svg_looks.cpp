// How lines look in the SVG files that are written for origami programs and machines.
// SPDX-License-Identifier: MIT
#include "io/svg_looks.h"

#include <algorithm>

#include "core/base/check.h"
#include "io/json_tree.h"

namespace kiri {

const SvgLineLook& svgLineLook(char letter) {
  const auto* found = std::find_if(kSvgLineLooks.begin(), kSvgLineLooks.end(),
                                   [&](const SvgLineLook& look) { return look.letter == letter; });
  KIRI_CHECK(found != kSvgLineLooks.end(), "every assignment has a look");
  return *found;
}

std::string svgGroupTag(const SvgLineLook& look, double strokeWidth) {
  std::string dashes;
  for (const double dash : look.dashes) {
    if (dash > 0) dashes += (dashes.empty() ? "" : " ") + numberText(dash * strokeWidth);
  }
  return std::string("  <g id=\"") + look.id + "\" data-name=\"" + look.label + "\" stroke=\"" +
         look.colour + "\"" + (dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"") +
         ">\n";
}

std::string xmlText(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (byte >= ' ' || c == '\n' || c == '\t') {
      out += c;
    }
  }
  return out;
}

}  // namespace kiri
