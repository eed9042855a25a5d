// Outlines of points are read from the tables that programs write.
// SPDX-License-Identifier: MIT
#include "io/patterns/outline_points.h"

#include <gtest/gtest.h>

#include <string>

namespace kiri {
namespace {

const std::vector<Vec2> kTriangle = {{0.5, 0}, {1, -2.5}, {3, 4}};

void expectTriangle(const std::string& text) {
  const Result<OutlinePoints> read = readOutlinePoints(text, "leaf.csv");
  ASSERT_TRUE(read) << text << ": " << read.error().message;
  EXPECT_EQ(read->points, kTriangle) << text;
}

TEST(OutlinePoints, AreApartByCommasBlanksTabsOrSemicolons) {
  expectTriangle("0.5,0\n1,-2.5\n3,4\n");
  expectTriangle("0.5 0\n1 -2.5\n3 4");
  expectTriangle("  0.5   0\r\n\r\n1 \t-2.5\r\n3\t4\r\n");
  expectTriangle("0.5\t0\n1\t-2.5\n3\t4\n");
  expectTriangle("0,5;0\n1;-2,5\n3;4\n");
}

TEST(OutlinePoints, MayHaveRemarksNamesAndOtherColumns) {
  expectTriangle("# a leaf\nx,y\n0.5,0\n1,-2.5\n3,4\n");
  expectTriangle("\xEF\xBB\xBFX;Y\n0.5;0\n1;-2.5\n3;4\n");
  expectTriangle("id,y,x\na,0,0.5\nb,-2.5,1\nc,4,3\n");
  expectTriangle("\"x\" \"y\"\n\"1\" 0.5 0\n\"2\" 1 -2.5\n\"3\" 3 4\n");  // as R writes
}

TEST(OutlinePoints, ThatRepeatTheirNeighbourCountOnce) {
  expectTriangle("0.5 0\n1 -2.5\n1 -2.5\n3 4\n0.5 0\n");
}

TEST(OutlinePoints, FaultsAreToldWithTheirLine) {
  const auto message = [](const std::string& text) {
    const Result<OutlinePoints> read = readOutlinePoints(text, "leaf.csv");
    return read ? std::string() : read.error().message;
  };
  EXPECT_EQ(message("x,y\n0,0\n1\n").rfind("leaf.csv line 3: \"1\" is no point", 0), 0u);
  EXPECT_EQ(message("0,0\n1,1e999\n").rfind("leaf.csv line 2", 0), 0u);
  EXPECT_EQ(message("0,0\n1,nan\n").rfind("leaf.csv line 2", 0), 0u);
  EXPECT_EQ(message("0 0\n1 1\n0 0").rfind("leaf.csv holds 2 different points", 0), 0u);
  EXPECT_EQ(message("").rfind("leaf.csv holds 0", 0), 0u);
}

TEST(OutlinePoints, AreKnownByTheEndingOfTheirFile) {
  EXPECT_TRUE(isNamedLikePoints("a/leaf.CSV"));
  EXPECT_TRUE(isNamedLikePoints("leaf.txt"));
  EXPECT_FALSE(isNamedLikePoints("leaf.kiri"));
  EXPECT_FALSE(isNamedLikePoints("leaf"));
}

}  // namespace
}  // namespace kiri
