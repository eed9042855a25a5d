// Measures agree with what can be worked out by hand, and leaves measure as their recipes say.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
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

TEST(LeafMeasures, OfARectangleHaveItsEllipseAndItsDiagonal) {
  const LeafMeasures m = measured(rectangleSheet(60, 40));
  EXPECT_NEAR(m.major / m.minor, 1.5, 1e-12);  // as the roots of the second moments
  EXPECT_NEAR(kPi * m.major * m.minor / 4, 2400, 1e-9);
  EXPECT_NEAR(m.roundness, 2.0 / 3, 1e-12);
  EXPECT_NEAR(m.feret, std::hypot(60, 40), 1e-9);
}

TEST(LeafMeasures, OfASlantedEllipseAreItsAxes) {
  std::vector<Vec2> points;
  for (int i = 0; i < 2000; ++i) {
    const double t = 2 * kPi * i / 2000;
    const Vec2 p{50 * std::cos(t), 20 * std::sin(t)};
    points.push_back(Vec2{0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y} + Vec2{300, -70});
  }
  const LeafMeasures m = measured(polygonSheet(points));
  EXPECT_NEAR(m.major, 100, 1e-3);
  EXPECT_NEAR(m.minor, 40, 1e-3);
  EXPECT_NEAR(m.roundness, 0.4, 1e-9);
  EXPECT_NEAR(m.feret, 100, 1e-9);
}

TEST(LeafMeasures, OfAKiteAreTheAnglesOfApexAndBase) {
  MeasureOptions options;
  options.petiole = Vec2{0, 0};
  // Broadest at half its length: the lines at 1/4 and 3/4 meet the four sides.
  const LeafMeasures m = measured(polygonSheet({{0, 0}, {10, 20}, {0, 40}, {-10, 20}}), options);
  const double opening = 2 * std::atan(0.5) * 180 / kPi;
  ASSERT_TRUE(m.apexAngle && m.baseAngle);
  EXPECT_NEAR(*m.apexAngle, opening, 1e-9);
  EXPECT_NEAR(*m.baseAngle, opening, 1e-9);
  EXPECT_EQ(m.royerLobeCount, 0);
  EXPECT_EQ(m.royerToothCount, 0);
}

TEST(LeafMeasures, OfAnUnevenKiteAreItsFluctuations) {
  MeasureOptions options;
  options.petiole = Vec2{0, 0};
  options.axis = 0;
  const LeafMeasures m = measured(polygonSheet({{0, 0}, {10, 20}, {0, 40}, {-13, 20}}), options);
  EXPECT_NEAR(m.leftWidth, 13, 1e-9);
  EXPECT_NEAR(m.rightWidth, 10, 1e-9);
  EXPECT_NEAR(m.widthAsymmetry, 3 / 11.5, 1e-12);
  EXPECT_NEAR(m.areaAsymmetry, 60 / 230.0, 1e-12);
}

/// A fan of tips at the given radii with sinuses between them, its base at the origin.
LeafMeasures fanWith(const std::vector<double>& radii) {
  std::vector<Vec2> outline = {{0, 0}};
  const double step = 140.0 / static_cast<double>(radii.size() - 1);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle = (70 - step * static_cast<double>(i)) * kPi / 180;
    outline.push_back({radii[i] * std::sin(angle), radii[i] * std::cos(angle)});
  }
  MeasureOptions options;
  options.petiole = Vec2{0, 0};
  return measured(polygonSheet(outline), options);
}

TEST(RoyersRule, TellsLobesFromTeeth) {
  // Tips at -70, -35, 0, 35, 70 degrees; the sinuses reach down to a part of them.
  const LeafMeasures lobed = fanWith({80, 40, 100, 40, 80});
  EXPECT_EQ(lobed.royerLobeCount, 3);
  EXPECT_EQ(lobed.royerToothCount, 0);
  const LeafMeasures toothed = fanWith({90, 86, 94, 90, 97, 93, 100, 93, 97, 90, 94, 86, 90});
  EXPECT_EQ(toothed.royerLobeCount, 0);
  EXPECT_EQ(toothed.royerToothCount, 6);
  // The foot of the sinus at 35 degrees on the axis of a tip of 80 mm.
  const double reach = 1 - 40 * std::cos(35 * kPi / 180) / 80;
  EXPECT_NEAR(lobed.margin.front().reach, reach, 1e-9);
}

TEST(RoyersRule, TakesTipsOfOneLengthForLobesOfOneKind) {
  MeasureOptions options;
  options.petiole = Vec2{50, 50};
  const LeafMeasures m = measured(rectangleSheet(100, 100), options);
  EXPECT_EQ(m.lobeCount, 4);
  EXPECT_EQ(m.royerLobeCount, 4);
  for (const MarginPoint& p : m.margin) {
    if (p.isLobe) EXPECT_NEAR(p.reach, 0.5, 1e-9);
  }
}

TEST(RoyersRule, CountsTeethOnALobeAsTeethAndTheLobeAsALobe) {
  // A tooth on either flank of each side lobe: deep sinuses stay those of the lobe.
  const LeafMeasures m = fanWith({70, 68, 80, 74, 76, 35, 100, 35, 76, 74, 80, 68, 70});
  EXPECT_EQ(m.lobeCount, 7);
  EXPECT_EQ(m.royerLobeCount, 3);
  EXPECT_EQ(m.royerToothCount, 4);
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
  // Veins N1 to N3, two sinuses, two angles of the vine's descriptors; N4 there is none.
  const struct {
    int code;
    double value;
  } oiv[] = {{601, 110},       {602, .88 * 110}, {603, .58 * 110}, {605, .62 * 110},
             {606, .45 * 110}, {607, 42},        {608, 46}};
  ASSERT_EQ(measures->oiv.size(), std::size(oiv));
  for (std::size_t i = 0; i < std::size(oiv); ++i) {
    EXPECT_EQ(measures->oiv[i].code, oiv[i].code);
    EXPECT_NEAR(measures->oiv[i].right.value(), oiv[i].value, 0.2) << oiv[i].code;
    EXPECT_NEAR(measures->oiv[i].left.value(), oiv[i].value, 0.2) << oiv[i].code;
  }
}

TEST(OivAngles, HaveFiveClasses) {
  EXPECT_EQ(oivAngleClass(30), 1);
  EXPECT_EQ(oivAngleClass(42), 3);
  EXPECT_EQ(oivAngleClass(55), 5);
  EXPECT_EQ(oivAngleClass(56), 7);
  EXPECT_EQ(oivAngleClass(71), 9);
}

}  // namespace
}  // namespace kiri
