// Numbers as text for files: the same everywhere, in any locale.
// SPDX-License-Identifier: MIT
#include "render/canvas/number_text.h"

#include <cmath>
#include <cstdint>

#include "core/base/check.h"

namespace kiri {

std::string numberText(double value, int decimals) {
  KIRI_CHECK(decimals >= 0 && decimals <= 9, "numbers are written with at most nine decimals");
  std::int64_t unit = 1;
  for (int i = 0; i < decimals; ++i) unit *= 10;
  const double scaled = std::round(value * static_cast<double>(unit));
  KIRI_CHECK(std::abs(scaled) < 9e18, "numbers in pictures are finite and of the size of pages");
  const auto whole = static_cast<std::int64_t>(scaled);
  const std::int64_t size = whole < 0 ? -whole : whole;
  std::string text = (whole < 0 ? "-" : "") + std::to_string(size / unit);
  std::string rest = std::to_string(size % unit);
  if (size % unit == 0) return text;
  rest.insert(0, static_cast<std::size_t>(decimals) - rest.size(), '0');
  rest.erase(rest.find_last_not_of('0') + 1);
  return text + "." + rest;
}

}  // namespace kiri
