// Sheets: outlines as they are asked for, and every polygon that is none refused with its place.
// SPDX-License-Identifier: MIT
#include "core/paper/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace kiri {
namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

/// Holds when the polygon is refused with a sentence that contains `fragment`.
testing::AssertionResult refuses(const std::vector<Vec2>& outline,
                                 const std::vector<std::vector<Vec2>>& holes,
                                 const std::string& fragment) {
  const Result<Sheet> result = polygonSheet(outline, holes);
  if (result) return testing::AssertionFailure() << "accepted";
  const std::string& message = result.error().message;
  if (result.error().code != ErrorCode::BadValue)
    return testing::AssertionFailure() << "another code";
  if (message.find(fragment) == std::string::npos) return testing::AssertionFailure() << message;
  if (message.back() == '.')
    return testing::AssertionFailure() << "ends with a full stop: " << message;
  return testing::AssertionSuccess();
}

TEST(RectangleSheet, LiesAtTheOriginCounterClockwise) {
  const Sheet sheet = *rectangleSheet(30, 40);
  ASSERT_EQ(sheet.outline.loops.size(), 1U);
  EXPECT_EQ(sheet.outline.loops[0].size(), 4U);
  EXPECT_EQ(sheet.outline.loops[0][0].start, (Vec2{0, 0}));
  EXPECT_EQ(areaOf(sheet.outline), 1200);
  EXPECT_EQ(sheet.tolerance().sheetSize(), 50);
}

TEST(RectangleSheet, RefusesSizesThatAreNone) {
  for (const double size : {0.0, -1.0, kInfinity, std::nan("")}) {
    EXPECT_FALSE(rectangleSheet(size, 1).isOk());
    EXPECT_FALSE(rectangleSheet(1, size).isOk());
    EXPECT_FALSE(squareSheet(size).isOk());
    EXPECT_FALSE(discSheet(size).isOk());
  }
  EXPECT_EQ(squareSheet(-3).error().message,
            "the side of the sheet is -3, but must be a number of mm above 0");
}

TEST(DiscSheet, StaysWithinAThousandMillionthOfTheCircle) {
  const double radius = 80;
  const Sheet sheet = *discSheet(radius);
  const Loop& border = sheet.outline.loops[0];
  ASSERT_EQ(border.size(), 32U);
  double worst = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    EXPECT_EQ(border[i].end, border[(i + 1) % border.size()].start);
    for (int k = 0; k <= 100; ++k) {
      const double r = distance(pointAt(border[i], k / 100.0), {radius, radius});
      worst = std::max(worst, std::abs(r - radius));
    }
  }
  EXPECT_LT(worst, 0.75e-9 * radius);
  EXPECT_NEAR(areaOf(sheet.outline), std::numbers::pi * radius * radius, 1e-9 * radius * radius);
}

TEST(DiscSheet, LiesInItsBox) {
  const Box box = boundsOf(discSheet(75)->outline);
  EXPECT_NEAR(box.low.x, 0, 1e-6);
  EXPECT_NEAR(box.high.y, 150, 1e-6);
}

TEST(PolygonSheet, TurnsLoopsAsARegionNeedsThem) {
  const std::vector<Vec2> outline{{0, 0}, {0, 100}, {100, 100}, {100, 0}};
  const std::vector<Vec2> hole{{40, 40}, {60, 40}, {50, 60}};
  const Sheet sheet = *polygonSheet(outline, {hole});
  EXPECT_GT(signedAreaOf(sheet.outline.loops[0]), 0);
  EXPECT_LT(signedAreaOf(sheet.outline.loops[1]), 0);
  EXPECT_EQ(areaOf(sheet.outline), 9800);
  for (const Loop& loop : sheet.outline.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      EXPECT_EQ(loop[i].end, loop[(i + 1) % loop.size()].start);
  }
}

TEST(PolygonSheet, TakesDentsAndCornersInOneLine) {
  EXPECT_TRUE(polygonSheet({{0, 0}, {50, 0}, {100, 0}, {100, 100}, {50, 20}, {0, 100}}).isOk());
}

TEST(PolygonSheet, RefusesTooFewCorners) {
  EXPECT_TRUE(refuses({{0, 0}, {1, 0}}, {}, "the outline has 2 corners, but needs at least three"));
  EXPECT_TRUE(refuses({{0, 0}, {9, 0}, {0, 9}}, {{{1, 1}}}, "hole 1 has 1 corners"));
}

TEST(PolygonSheet, RefusesNumbersThatAreNone) {
  EXPECT_TRUE(refuses({{0, 0}, {kInfinity, 0}, {1, 1}}, {}, "corner 2 of the outline is not"));
}

TEST(PolygonSheet, RefusesRepeatedCorners) {
  EXPECT_TRUE(refuses({{0, 0}, {9, 0}, {9, 0}, {0, 9}}, {},
                      "corners 2 and 3 of the outline are the same point (9, 0) mm"));
  EXPECT_TRUE(refuses({{0, 0}, {9, 0}, {0, 9}, {0, 0}}, {},
                      "corners 4 and 1 of the outline are the same point"));
  EXPECT_TRUE(refuses({{1, 1}, {1, 1}, {1, 1}}, {}, "the same point (1, 1) mm"));
}

TEST(PolygonSheet, RefusesCrossingSidesWithTheirPlace) {
  EXPECT_TRUE(refuses({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {},
                      "side 1 of the outline meets side 3 of the outline at (5, 5) mm"));
}

TEST(PolygonSheet, RefusesTouchingSides) {
  EXPECT_TRUE(refuses({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}, {}, "at (5, 0) mm"));
  EXPECT_TRUE(refuses({{0, 0}, {5, 0}, {5, 5}, {9, 5}, {9, 9}, {5, 9}, {5, 5}, {0, 5}}, {},
                      "at (5, 5) mm"));
  EXPECT_TRUE(refuses({{0, 0}, {10, 0}, {10, 10}, {10, 5}, {0, 5}}, {},
                      "side 2 of the outline meets side 3"));
}

TEST(PolygonSheet, RefusesOutlinesWithoutArea) {
  EXPECT_FALSE(polygonSheet({{0, 0}, {5, 0}, {10, 0}}).isOk());
  EXPECT_TRUE(refuses({{0, 0}, {50, 1e-8}, {100, 0}, {50, 2e-8}}, {}, ""));
}

TEST(PolygonSheet, RefusesHolesThatAreNotInside) {
  const std::vector<Vec2> outline{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const std::vector<Vec2> hole{{40, 40}, {60, 40}, {50, 60}};
  EXPECT_TRUE(refuses(outline, {hole, {{140, 40}, {160, 40}, {150, 60}}},
                      "hole 2 lies outside of the outline"));
  EXPECT_TRUE(refuses(outline, {{{90, 40}, {110, 40}, {95, 60}}},
                      "side 2 of the outline meets side 1 of hole 1 at (100, 40) mm"));
  EXPECT_TRUE(
      refuses(outline, {hole, {{45, 42}, {55, 42}, {50, 50}}}, "hole 2 lies inside hole 1"));
  EXPECT_TRUE(refuses(outline, {hole, {{50, 45}, {70, 45}, {50, 80}}}, "meets side"));
  EXPECT_TRUE(
      refuses(outline, {{{-10, -10}, {110, -10}, {110, 110}, {-10, 110}}}, "hole 1 lies outside"));
  EXPECT_TRUE(refuses(outline, {{{0, 40}, {20, 30}, {20, 50}}}, "at (0, 40) mm"));
}

TEST(PolygonSheet, PointsAtThePlace) {
  const Result<Sheet> result = polygonSheet({{0, 0}, {10, 10}, {10, 0}, {0, 10}});
  ASSERT_EQ(result.error().witness.points.size(), 1U);
  EXPECT_EQ(result.error().witness.points[0], (Vec2{5, 5}));
}

}  // namespace
}  // namespace kiri
