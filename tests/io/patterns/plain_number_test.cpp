// Numbers of text files: the nearest double, in every locale.
// SPDX-License-Identifier: MIT
#include "io/patterns/plain_number.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <vector>

#include "io/json_tree.h"

namespace kiri {
namespace {

TEST(PlainNumber, AnyDoubleComesBackToTheLastBit) {
  std::mt19937_64 random(5);
  int checked = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    ++checked;
    ASSERT_EQ(numberOf(numberText(value)), value) << numberText(value);
    const double usual = std::ldexp(static_cast<double>(bits >> 11), -45);
    ASSERT_EQ(numberOf(numberText(usual)), usual) << numberText(usual);
  }
  EXPECT_GT(checked, 19000);
}

TEST(PlainNumber, ManyDigitsGiveWhatTheStandardLibraryGives) {
  std::setlocale(LC_NUMERIC, "C");
  std::mt19937_64 random(6);
  for (int i = 0; i < 5000; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    for (std::uint64_t k = 1 + random() % 30; k > 0; --k)
      text += static_cast<char>('0' + random() % 10);
    text += '.';
    for (std::uint64_t k = random() % 30; k > 0; --k)
      text += static_cast<char>('0' + random() % 10);
    if (random() % 2 == 0) text += "e" + std::to_string(static_cast<int>(random() % 640) - 320);
    ASSERT_EQ(numberOf(text), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(PlainNumber, TakesAsMuchAsIsANumber) {
  std::string_view text = "-1.5.5e2-3e+q 1d2";
  EXPECT_EQ(takeNumber(text), -1.5);
  EXPECT_EQ(takeNumber(text), 50.0);
  EXPECT_EQ(takeNumber(text), -3.0);
  EXPECT_EQ(text, "e+q 1d2");
  EXPECT_EQ(takeNumber(text), std::nullopt);
  text.remove_prefix(4);
  EXPECT_EQ(takeNumber(text), 100.0);
}

TEST(PlainNumber, WhatIsNoNumberIsNone) {
  for (const char* text : {"", "-", ".", "+.", "e5", "nan", "inf", "0x10", "1,5", "1 2", "--1"}) {
    EXPECT_EQ(numberOf(text), std::nullopt) << text;
  }
  EXPECT_EQ(numberOf(" 5. \r\n"), 5.0);
  EXPECT_EQ(numberOf(".5"), 0.5);
}

TEST(PlainNumber, WhatIsTooLargeIsInfiniteAndWhatIsTooSmallIsZero) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const char* text : {"1e400", "1e309", "1e999999999999", "123456789012345678901e300"}) {
    EXPECT_EQ(numberOf(text), kInfinite) << text;
    EXPECT_EQ(numberOf("-" + std::string(text)), -kInfinite) << text;
  }
  EXPECT_EQ(numberOf(std::string(1000, '9')), kInfinite);
  EXPECT_EQ(numberOf("1e-999999999999"), 0.0);
  EXPECT_EQ(numberOf("0." + std::string(1000, '0') + "1e1001"), 1.0);
  EXPECT_EQ(numberOf(std::string(500, '0') + "7"), 7.0);
  EXPECT_EQ(numberOf("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
}

struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(PlainNumber, IsTheSameWhereCommasDivide) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  const std::optional<double> value = numberOf("0.1234567890123456789");
  const std::optional<double> large = numberOf("1234.5678901234567890123");
  std::locale::global(before);
  EXPECT_EQ(value, 0.1234567890123456789);
  EXPECT_EQ(large, 1234.5678901234567890123);
}

}  // namespace
}  // namespace kiri
