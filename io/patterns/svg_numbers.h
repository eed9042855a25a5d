// Lists of numbers, lengths and transforms in the attributes of SVG.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "core/base/vec.h"

namespace kiri {

/// x' = a x + c y + e, y' = b x + d y + f.
struct SvgMatrix {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  constexpr Vec2 apply(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  constexpr Vec2 direction(Vec2 p) const { return {a * p.x + c * p.y, b * p.x + d * p.y}; }
  constexpr bool operator==(const SvgMatrix&) const = default;
};
/// First `inner`, then `outer`.
SvgMatrix compose(const SvgMatrix& outer, const SvgMatrix& inner);

/// Takes blanks and one comma off the text.
void skipSvgSeparators(std::string_view& text);
/// Takes the next number of a list off the text; none when something else comes next.
std::optional<double> takeListed(std::string_view& text);

/// The value of `transform`: matrix, translate, scale, rotate (about a point too), skewX, skewY,
/// one after the other. None when it is none of these.
std::optional<SvgMatrix> svgTransformOf(std::string_view text);

/// A number with its unit.
struct SvgLength {
  enum class Unit { User, Pixel, Percent, Millimetre, Centimetre, Inch, Point, Pica, Quarter, Em };
  double value = 0;
  Unit unit = Unit::User;

  /// In user units, of which 96 are an inch; a percentage of `whole`.
  double inUser(double whole) const;
  /// True size, where the unit has one: pixels have none.
  std::optional<double> inMm() const;
};
std::optional<SvgLength> svgLengthOf(std::string_view text);

}  // namespace kiri
