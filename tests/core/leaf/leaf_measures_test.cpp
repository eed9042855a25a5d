// Measures agree with what can be worked out by hand, and leaves measure as their recipes say.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/leaf/leaf_model.h"
#include "core/model/replay.h"

namespace kiri {
namespace {

constexpr double kPi = std::numbers::pi;

LeafMeasures measured(const Result<Sheet>& sheet, const MeasureOptions& options = {}) {
  const Result<LeafMeasures> measures = measuresOf(patternOf(sheet.value()), options);
  EXPECT_TRUE(measures) << measures.error().message;
  return *measures;
}

TEST(LeafMeasures, OfARectangleWithItsPetioleInTheMiddleOfASide) {
  MeasureOptions options;
  options.petiole = Vec2{30, 0};
  options.axis = 0;
  const LeafMeasures m = measured(rectangleSheet(60, 40), options);
  EXPECT_NEAR(m.length, 40, 1e-9);
  EXPECT_NEAR(m.width, 60, 1e-9);
  EXPECT_NEAR(m.area, 2400, 1e-9);
  EXPECT_NEAR(m.perimeter, 200, 1e-9);
  EXPECT_NEAR(m.aspectRatio, 2.0 / 3, 1e-12);
  EXPECT_NEAR(m.solidity, 1, 1e-12);
  EXPECT_NEAR(m.circularity, 4 * kPi * 2400 / 40000, 1e-12);
  EXPECT_NEAR(m.leftArea, 1200, 1e-9);
  EXPECT_NEAR(m.rightArea, 1200, 1e-9);
  EXPECT_NEAR(m.asymmetry, 0, 1e-9);
  // Two corners are lobes; between them the far side is nearest at the axis.
  EXPECT_EQ(m.lobeCount, 2);
  EXPECT_EQ(m.sinusCount, 1);
  EXPECT_NEAR(m.margin[1].angle, 0, 1e-6);
  EXPECT_NEAR(m.margin[1].length, 40, 1e-9);
}

TEST(LeafMeasures, OfADiscHaveNoLobes) {
  const LeafMeasures m = measured(discSheet(50));
  EXPECT_NEAR(m.circularity, 1, 1e-6);
  EXPECT_NEAR(m.area, kPi * 2500, 1e-3);
  EXPECT_NEAR(m.aspectRatio, 0.5, 1e-6);  // from the middle to the rim
  EXPECT_EQ(m.lobeCount, 0);
}

TEST(LeafMeasures, OfAStarAreItsTipsAndNotches) {
  std::vector<Vec2> star;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 50 : 20;
    star.push_back({r * std::sin(kPi * i / 5), r * std::cos(kPi * i / 5)});
  }
  const LeafMeasures m = measured(polygonSheet(star));
  EXPECT_EQ(m.lobeCount, 5);
  EXPECT_EQ(m.sinusCount, 5);
  const double hull = 2.5 * 2500 * std::sin(2 * kPi / 5);
  EXPECT_NEAR(m.solidity, 5 * 50 * 20 * std::sin(kPi / 5) / hull, 1e-9);
  for (const MarginPoint& p : m.margin) EXPECT_NEAR(p.length, p.isLobe ? 50 : 20, 1e-9);
}

TEST(LeafMeasures, AnUnevenOutlineIsNotSymmetric) {
  MeasureOptions options;
  options.petiole = Vec2{0, 0};
  options.axis = 0;
  const LeafMeasures m = measured(polygonSheet({{0, 0}, {10, 20}, {0, 40}, {-13, 20}}), options);
  EXPECT_NEAR(m.rightArea, 200, 1e-9);
  EXPECT_NEAR(m.leftArea, 260, 1e-9);
  // The mirror image of the corner at 13 mm lies straight beyond the one at 10 mm.
  EXPECT_NEAR(m.asymmetry, 3, 1e-9);
}

TEST(LeafMeasures, OfALeafAreTheAnglesAndLengthsOfItsRecipe) {
  LeafRecipe recipe;
  recipe.midVein = 110;
  recipe.veins = {{42, .88}, {88, .58}};
  recipe.antiVeins = {{24, .62}, {75, .45}};
  recipe.base = {118, .30};
  const Result<LeafModel> leaf = leafModelOf(recipe);
  ASSERT_TRUE(leaf);
  const Result<Replay> replayed = replay(leaf->model);
  ASSERT_TRUE(replayed);
  const auto last = replayed->after(leaf->model.steps.size());
  ASSERT_TRUE(last);
  const Result<LeafMeasures> measures = measuresOf((*last)->pattern);
  ASSERT_TRUE(measures) << measures.error().message;
  EXPECT_NEAR(measures->length, 110, 1e-6);
  EXPECT_LT(measures->asymmetry, 1e-9 * 110);
  std::vector<double> angles;
  for (const MarginPoint& p : measures->margin) angles.push_back(p.angle);
  const std::vector<double> wanted = {-88, -75, -42, -24, 0, 24, 42, 75, 88};
  ASSERT_EQ(angles.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(angles[i], wanted[i], 0.1);
  EXPECT_EQ(measures->lobeCount, 5);
  EXPECT_EQ(measures->sinusCount, 4);
}

}  // namespace
}  // namespace kiri
