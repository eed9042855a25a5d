// Numbers as text files of other programs have them, read exactly and the same in every locale.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace kiri {

/// Takes the number at the start of `text` off it: sign, digits, point, exponent (E, e, or the D of
/// Fortran), as much as makes sense. None, and `text` as it was, where no number stands there. The
/// double nearest to the decimals; beyond its range infinite.
std::optional<double> takeNumber(std::string_view& text);

/// The number that the whole text is, spaces around it allowed; none when it is something else.
std::optional<double> numberOf(std::string_view text);

/// Coordinates and angles beyond this are no drawing: products of them stay far from infinity.
inline constexpr double kLargestDrawn = 1e12;

/// True for a coordinate that a drawing may have.
constexpr bool isDrawable(double value) {
  return value >= -kLargestDrawn && value <= kLargestDrawn;
}

}  // namespace kiri
