// Numbers as text files of other programs have them, read exactly and the same in every locale.
// SPDX-License-Identifier: MIT
#include "io/patterns/plain_number.h"

#include <array>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace kiri {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

/// A number in pieces: value = +-digits * 10^exponent, where all digits fit.
struct Decimal {
  bool isNegative = false;
  std::uint64_t digits = 0;
  int figures = 0;  ///< of `digits`, without leading zeros; more than kMostFigures do not fit
  int exponent = 0;

  static constexpr int kMostFigures = 19;
  static constexpr int kLargestExponent = 100'000;

  void addDigit(char c, bool isFraction) {
    if (digits == 0 && c == '0') {
      if (isFraction && exponent > -kLargestExponent) --exponent;
      return;
    }
    ++figures;
    if (figures <= kMostFigures) digits = digits * 10 + static_cast<std::uint64_t>(c - '0');
    if (isFraction && exponent > -kLargestExponent) --exponent;
  }
};

/// The length of the exponent at the start of the text, 0 for none; adds it to `number`.
std::size_t readExponent(std::string_view text, Decimal& number) {
  if (text.empty()) return 0;
  if (text[0] != 'e' && text[0] != 'E' && text[0] != 'd' && text[0] != 'D') return 0;
  std::size_t at = 1;
  const bool isNegative = at < text.size() && text[at] == '-';
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  const std::size_t first = at;
  int exponent = 0;
  for (; at < text.size() && isDigit(text[at]); ++at) {
    if (exponent < Decimal::kLargestExponent) exponent = exponent * 10 + (text[at] - '0');
  }
  if (at == first) return 0;
  number.exponent += isNegative ? -exponent : exponent;
  return at;
}

/// The length of the number at the start of the text, 0 for none.
std::size_t readDecimal(std::string_view text, Decimal& number) {
  std::size_t at = 0;
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
    number.isNegative = text[0] == '-';
    at = 1;
  }
  const std::size_t first = at;
  for (; at < text.size() && isDigit(text[at]); ++at) number.addDigit(text[at], false);
  std::size_t count = at - first;
  if (at < text.size() && text[at] == '.') {
    const std::size_t point = at++;
    for (; at < text.size() && isDigit(text[at]); ++at) number.addDigit(text[at], true);
    count += at - point - 1;
  }
  if (count == 0) return 0;
  return at + readExponent(text.substr(at), number);
}

/// Exact where digits and power of ten are doubles without rounding (Clinger's fast path).
std::optional<double> exactly(const Decimal& number) {
  static constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::uint64_t kExactInteger = std::uint64_t{1} << 53;
  constexpr int kMost = 22;
  if (number.figures > Decimal::kMostFigures || number.digits > kExactInteger) return std::nullopt;
  const auto digits = static_cast<double>(number.digits);
  if (number.digits == 0) return digits;
  if (number.exponent < -kMost || number.exponent > kMost) return std::nullopt;
  return number.exponent < 0 ? digits / kPowers[static_cast<std::size_t>(-number.exponent)]
                             : digits * kPowers[static_cast<std::size_t>(number.exponent)];
}

/// By the standard library, in the locale that never changes. `text` is a number without sign.
double carefully(std::string_view text, const Decimal& number) {
  constexpr int kBeyond = 400;  // more than any double has, at either end
  const int size = number.exponent + number.figures;
  if (size > kBeyond) return std::numeric_limits<double>::infinity();
  if (size < -kBeyond) return 0;
  std::string plain(text);
  for (char& c : plain) {
    if (c == 'd' || c == 'D') c = 'e';
  }
  std::istringstream in(plain);
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  if (in.fail() && value > 1) return std::numeric_limits<double>::infinity();
  return value;
}

}  // namespace

std::optional<double> takeNumber(std::string_view& text) {
  Decimal number;
  const std::size_t length = readDecimal(text, number);
  if (length == 0) return std::nullopt;
  std::optional<double> value = exactly(number);
  if (!value) {
    const std::size_t sign = text[0] == '-' || text[0] == '+' ? 1 : 0;
    value = carefully(text.substr(sign, length - sign), number);
  }
  text.remove_prefix(length);
  return number.isNegative ? -*value : *value;
}

std::optional<double> numberOf(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  const std::optional<double> value = takeNumber(text);
  return text.empty() ? value : std::nullopt;
}

}  // namespace kiri
