// What layers and colours of a DXF file mean.
// SPDX-License-Identifier: MIT
#include "io/patterns/dxf_layers.h"

#include <algorithm>
#include <string>

namespace kiri {

std::optional<Assignment> assignmentOfLayer(std::string_view name) {
  std::string small(name);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (std::size_t i = 0; i < kDxfLayers.size(); ++i) {
    std::string known = kDxfLayers[i].name;
    for (char& c : known) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (small == known) return static_cast<Assignment>(i);
  }
  const auto says = [&](const char* word) { return small.find(word) != std::string::npos; };
  if (says("mountain")) return Assignment::Mountain;
  if (says("valley")) return Assignment::Valley;
  if (says("unassigned")) return Assignment::Unassigned;
  if (says("slit") || says("kerf")) return Assignment::Cut;
  if (says("border") || says("boundary") || says("outline") || says("contour") || says("cut")) {
    return Assignment::Border;
  }
  if (says("aux") || says("flat") || says("construction")) return Assignment::Flat;
  if (says("crease") || says("fold") || says("score")) return Assignment::Unassigned;
  return std::nullopt;
}

Assignment assignmentOfColour(int colour) {
  const auto isIn = [&](int low, int high) { return colour >= low && colour <= high; };
  if (colour == 1 || isIn(10, 39)) return Assignment::Mountain;
  if (colour == 2 || colour == 5 || isIn(140, 199)) return Assignment::Valley;
  if (colour == 3 || isIn(60, 129)) return Assignment::Border;
  if (colour == 6 || isIn(200, 239)) return Assignment::Unassigned;
  if (colour == 0 || colour == 7 || colour == 250 || colour == 255) return Assignment::Border;
  return Assignment::Flat;
}

int indexOfTrueColour(unsigned colour) {
  const auto red = static_cast<int>(colour >> 16U & 0xFFU);
  const auto green = static_cast<int>(colour >> 8U & 0xFFU);
  const auto blue = static_cast<int>(colour & 0xFFU);
  constexpr int kStrong = 128;
  const int bits =
      (red >= kStrong ? 4 : 0) + (green >= kStrong ? 2 : 0) + (blue >= kStrong ? 1 : 0);
  const int spread = std::max({red, green, blue}) - std::min({red, green, blue});
  constexpr int kGrey = 40;
  constexpr int kBlack = 64;
  constexpr int kWhite = 192;
  if (spread < kGrey) return red < kBlack || red > kWhite ? 7 : 8;
  constexpr std::array<int, 8> kIndex = {7, 5, 3, 4, 1, 6, 2, 7};
  if (bits != 0 && bits != 7) {
    // Yellow as a true colour is no valley, whatever ORIPA makes of index 2.
    return bits == 6 ? 50 : kIndex[static_cast<std::size_t>(bits)];
  }
  if (red >= green && red >= blue) return 1;
  return green >= blue ? 3 : 5;
}

}  // namespace kiri
