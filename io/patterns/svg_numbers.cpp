// Lists of numbers, lengths and transforms in the attributes of SVG.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_numbers.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "io/patterns/plain_number.h"

namespace kiri {

namespace {

bool isSvgBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

void skipSvgBlanks(std::string_view& text) {
  while (!text.empty() && isSvgBlank(text.front())) text.remove_prefix(1);
}

/// Sine and cosine that are exact at right angles, so that a turned square stays one.
SvgMatrix rotation(double degrees) {
  constexpr double kTurn = 360;
  constexpr double kQuarter = 90;
  const double rest = std::fmod(degrees, kTurn);
  const double quarters = rest / kQuarter;
  if (quarters == std::floor(quarters)) {
    constexpr std::array<double, 4> kSines{0, 1, 0, -1};
    const auto turn = static_cast<std::size_t>((static_cast<int>(quarters) + 4) % 4);
    const double s = kSines[turn];
    const double c = kSines[(turn + 1) % 4];
    return {c, s, -s, c, 0, 0};
  }
  const double angle = rest * std::numbers::pi / (kTurn / 2);
  return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
}

double slopeOf(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

struct Arguments {
  std::array<double, 6> values{};
  std::size_t count = 0;
};

/// The numbers between brackets, brackets taken too.
std::optional<Arguments> takeArguments(std::string_view& text) {
  skipSvgBlanks(text);
  if (text.empty() || text.front() != '(') return std::nullopt;
  text.remove_prefix(1);
  Arguments found;
  skipSvgBlanks(text);
  while (!text.empty() && text.front() != ')') {
    const std::optional<double> value = takeListed(text);
    if (!value || found.count == found.values.size()) return std::nullopt;
    found.values[found.count++] = *value;
    skipSvgSeparators(text);
  }
  if (text.empty()) return std::nullopt;
  text.remove_prefix(1);
  return found;
}

std::optional<SvgMatrix> rotationOf(const Arguments& given) {
  const auto& v = given.values;
  const SvgMatrix turn = rotation(v[0]);
  if (given.count == 1) return turn;
  if (given.count != 3) return std::nullopt;
  return compose({1, 0, 0, 1, v[1], v[2]}, compose(turn, {1, 0, 0, 1, -v[1], -v[2]}));
}

std::optional<SvgMatrix> matrixOf(std::string_view name, const Arguments& given) {
  const auto& v = given.values;
  const std::size_t n = given.count;
  if (name == "matrix" && n == 6) return SvgMatrix{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return SvgMatrix{1, 0, 0, 1, v[0], v[1]};
  if (name == "scale" && n == 1) return SvgMatrix{v[0], 0, 0, v[0], 0, 0};
  if (name == "scale" && n == 2) return SvgMatrix{v[0], 0, 0, v[1], 0, 0};
  if (name == "rotate") return rotationOf(given);
  if (name == "skewX" && n == 1) return SvgMatrix{1, 0, slopeOf(v[0]), 1, 0, 0};
  if (name == "skewY" && n == 1) return SvgMatrix{1, slopeOf(v[0]), 0, 1, 0, 0};
  return std::nullopt;
}

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

SvgMatrix compose(const SvgMatrix& outer, const SvgMatrix& inner) {
  const Vec2 x = outer.direction({inner.a, inner.b});
  const Vec2 y = outer.direction({inner.c, inner.d});
  const Vec2 o = outer.apply({inner.e, inner.f});
  return {x.x, x.y, y.x, y.y, o.x, o.y};
}

void skipSvgSeparators(std::string_view& text) {
  skipSvgBlanks(text);
  if (text.empty() || text.front() != ',') return;
  text.remove_prefix(1);
  skipSvgBlanks(text);
}

std::optional<double> takeListed(std::string_view& text) {
  skipSvgSeparators(text);
  return takeNumber(text);
}

std::optional<SvgMatrix> svgTransformOf(std::string_view text) {
  SvgMatrix all;
  skipSvgSeparators(text);
  if (text == "none") return all;
  while (!text.empty()) {
    std::size_t length = 0;
    while (length < text.size() && isLetter(text[length])) ++length;
    const std::string_view name = text.substr(0, length);
    text.remove_prefix(length);
    const std::optional<Arguments> given = takeArguments(text);
    if (!given) return std::nullopt;
    const std::optional<SvgMatrix> one = matrixOf(name, *given);
    if (!one) return std::nullopt;
    all = compose(all, *one);
    skipSvgSeparators(text);
  }
  return all;
}

double SvgLength::inUser(double whole) const {
  constexpr double kPerInch = 96;
  constexpr double kFont = 16;  // what "medium" text is where nothing else is said
  if (unit == Unit::Percent) return value / 100 * whole;
  if (unit == Unit::Em) return value * kFont;
  const std::optional<double> mm = inMm();
  return mm ? *mm * (kPerInch / 25.4) : value;
}

std::optional<double> SvgLength::inMm() const {
  constexpr double kInchOfPage = 25.4;
  switch (unit) {
    case Unit::Millimetre:
      return value;
    case Unit::Centimetre:
      return value * 10;
    case Unit::Inch:
      return value * kInchOfPage;
    case Unit::Point:
      return value * kInchOfPage / 72;
    case Unit::Pica:
      return value * kInchOfPage / 6;
    case Unit::Quarter:
      return value / 4;
    case Unit::User:
    case Unit::Pixel:
    case Unit::Percent:
    case Unit::Em:
      break;
  }
  return std::nullopt;
}

std::optional<SvgLength> svgLengthOf(std::string_view text) {
  using Unit = SvgLength::Unit;
  constexpr std::array<std::pair<std::string_view, Unit>, 11> kUnits{{
      {"", Unit::User},
      {"px", Unit::Pixel},
      {"%", Unit::Percent},
      {"mm", Unit::Millimetre},
      {"cm", Unit::Centimetre},
      {"in", Unit::Inch},
      {"pt", Unit::Point},
      {"pc", Unit::Pica},
      {"q", Unit::Quarter},
      {"Q", Unit::Quarter},
      {"em", Unit::Em},
  }};
  skipSvgBlanks(text);
  const std::optional<double> value = takeNumber(text);
  if (!value) return std::nullopt;
  skipSvgBlanks(text);
  while (!text.empty() && isSvgBlank(text.back())) text.remove_suffix(1);
  for (const auto& [name, unit] : kUnits) {
    if (name == text) return SvgLength{*value, unit};
  }
  return std::nullopt;
}

}  // namespace kiri
