// Colours in SVG, and what they mean in crease patterns.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "io/patterns/plain_number.h"
#include "io/patterns/svg_colour_names.h"
#include "io/patterns/svg_numbers.h"

namespace kiri {

namespace {

constexpr double kFull = 255;

SvgColour ofBits(std::uint32_t rgb) {
  return {static_cast<double>(rgb >> 16 & 0xFF), static_cast<double>(rgb >> 8 & 0xFF),
          static_cast<double>(rgb & 0xFF), 1};
}

std::optional<int> hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return std::nullopt;
}

std::optional<SvgColour> hexColour(std::string_view digits) {
  const bool isShort = digits.size() == 3 || digits.size() == 4;
  if (!isShort && digits.size() != 6 && digits.size() != 8) return std::nullopt;
  std::array<double, 4> parts{0, 0, 0, kFull};
  const std::size_t step = isShort ? 1 : 2;
  for (std::size_t i = 0; i * step < digits.size(); ++i) {
    const std::optional<int> high = hexDigit(digits[i * step]);
    const std::optional<int> low = hexDigit(digits[i * step + step - 1]);
    if (!high || !low) return std::nullopt;
    parts[i] = *high * 16 + *low;
  }
  return SvgColour{parts[0], parts[1], parts[2], parts[3] / kFull};
}

struct ColourPart {
  double value = 0;
  bool isPercent = false;
};

/// Numbers of rgb() and hsl(): blanks, commas or a slash between them, "deg" left out.
std::optional<std::array<ColourPart, 4>> colourParts(std::string_view text) {
  std::array<ColourPart, 4> parts{{{0, false}, {0, false}, {0, false}, {1, false}}};
  std::size_t count = 0;
  while (skipSvgSeparators(text), !text.empty()) {
    if (text.front() == '/') {
      text.remove_prefix(1);
      continue;
    }
    const std::optional<double> value = takeNumber(text);
    if (!value || !std::isfinite(*value) || count == parts.size()) return std::nullopt;
    parts[count].value = *value;
    if (!text.empty() && text.front() == '%') {
      parts[count].isPercent = true;
      text.remove_prefix(1);
    } else if (text.substr(0, 3) == "deg") {
      text.remove_prefix(3);
    }
    ++count;
  }
  if (count < 3) return std::nullopt;
  return parts;
}

/// The share of one channel in a colour of full chroma at that hue, CSS Color 4 section 7.1.
SvgColour ofHue(double degrees, double saturation, double lightness) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(std::fmod(shift + degrees / 30, 12) + 12, 12);
    const double chroma = saturation * std::min(lightness, 1 - lightness);
    return kFull * (lightness - chroma * std::max(-1.0, std::min({k - 3, 9 - k, 1.0})));
  };
  return {channel(0), channel(8), channel(4), 1};
}

std::optional<SvgColour> functionColour(std::string_view name, std::string_view inside) {
  const auto parts = colourParts(inside);
  if (!parts) return std::nullopt;
  const auto& p = *parts;
  SvgColour colour;
  if (name == "rgb" || name == "rgba") {
    const auto channel = [](const ColourPart& part) {
      return std::clamp(part.isPercent ? part.value * kFull / 100 : part.value, 0.0, kFull);
    };
    colour = {channel(p[0]), channel(p[1]), channel(p[2]), 1};
  } else if (name == "hsl" || name == "hsla") {
    colour = ofHue(p[0].value, std::clamp(p[1].value / 100, 0.0, 1.0),
                   std::clamp(p[2].value / 100, 0.0, 1.0));
  } else {
    return std::nullopt;
  }
  colour.alpha = std::clamp(p[3].isPercent ? p[3].value / 100 : p[3].value, 0.0, 1.0);
  return colour;
}

std::string trimmedLower(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool isBlank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (isBlank && out.empty()) continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  while (!out.empty() &&
         (out.back() == ' ' || out.back() == '\t' || out.back() == '\n' || out.back() == '\r')) {
    out.pop_back();
  }
  return out;
}

bool isNear(const SvgColour& a, const SvgColour& b) {
  // As files round: hsl() and percentages do not hit whole numbers.
  constexpr double kRounding = 1.5;
  return std::fabs(a.red - b.red) < kRounding && std::fabs(a.green - b.green) < kRounding &&
         std::fabs(a.blue - b.blue) < kRounding;
}

/// Degrees, red at 0; requires a colour that is no grey.
double hueOf(const SvgColour& c, double largest, double chroma) {
  double sixth = 0;
  if (largest == c.red) {
    sixth = (c.green - c.blue) / chroma;
  } else if (largest == c.green) {
    sixth = 2 + (c.blue - c.red) / chroma;
  } else {
    sixth = 4 + (c.red - c.green) / chroma;
  }
  return sixth < 0 ? (sixth + 6) * 60 : sixth * 60;
}

}  // namespace

std::optional<SvgColour> svgColourOf(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  if (text.size() > kLongest) return std::nullopt;
  const std::string word = trimmedLower(text);
  if (word.empty()) return std::nullopt;
  if (word[0] == '#') return hexColour(std::string_view(word).substr(1));
  if (const std::optional<std::uint32_t> named = namedColour(word)) return ofBits(*named);
  const std::size_t open = word.find('(');
  if (open == std::string::npos || word.back() != ')') return std::nullopt;
  return functionColour(std::string_view(word).substr(0, open),
                        std::string_view(word).substr(open + 1, word.size() - open - 2));
}

std::string hexOf(const SvgColour& colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "#";
  for (const double part : {colour.red, colour.green, colour.blue}) {
    const auto byte = static_cast<std::size_t>(std::lround(std::clamp(part, 0.0, kFull)));
    out += kDigits[byte / 16];
    out += kDigits[byte % 16];
  }
  return out;
}

ColourMeaning meaningOf(const SvgColour& colour) {
  struct Known {
    std::uint32_t rgb;
    Assignment assignment;
  };
  constexpr std::array<Known, 9> kKnown{{{0xff0000, Assignment::Mountain},
                                         {0x0000ff, Assignment::Valley},
                                         {0x000000, Assignment::Border},
                                         {0x00ff00, Assignment::Cut},
                                         {0x008000, Assignment::Cut},
                                         {0xffff00, Assignment::Join},
                                         {0xff00ff, Assignment::Unassigned},
                                         {0x808080, Assignment::Flat},
                                         {0x888888, Assignment::Flat}}};
  for (const Known& known : kKnown) {
    if (isNear(colour, ofBits(known.rgb))) return {known.assignment, true};
  }
  const double largest = std::max({colour.red, colour.green, colour.blue});
  const double chroma = largest - std::min({colour.red, colour.green, colour.blue});
  constexpr double kGreyish = 40;
  constexpr double kHalfGrey = 64;
  if (chroma < kGreyish) {
    return {largest < kHalfGrey ? Assignment::Border : Assignment::Flat, false};
  }
  constexpr std::array<Assignment, 6> kByHue{Assignment::Mountain, Assignment::Join,
                                             Assignment::Cut,      Assignment::Flat,
                                             Assignment::Valley,   Assignment::Unassigned};
  const double sixth = hueOf(colour, largest, chroma) / 60;
  return {kByHue[static_cast<std::size_t>(std::lround(sixth)) % kByHue.size()], false};
}

}  // namespace kiri
