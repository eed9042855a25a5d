// Clipping of convex polygons: properties, and the tolerances on both sides.
// SPDX-License-Identifier: MIT
#include "core/geometry/convex.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/core/geometry/shapes.h"

namespace kiri {
namespace {

using test::Random;
using test::randomConvex;

constexpr double kSize = 141.4;
constexpr double kEps = 1e-10 * kSize;
constexpr double kFat = 1e-7 * kSize;

TEST(SignedArea, IsPositiveCounterClockwise) {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 3}, {0, 3}};
  EXPECT_EQ(signedArea(square), 6);
  EXPECT_EQ(signedArea(std::vector<Vec2>(square.rbegin(), square.rend())), -6);
}

TEST(Intersection, DoesNotDependOnTheOrder) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Vec2> a = randomConvex(random, random.count(3, 12));
    const std::vector<Vec2> b = randomConvex(random, random.count(3, 12));
    EXPECT_NEAR(signedArea(intersection(a, b, kEps)), signedArea(intersection(b, a, kEps)),
                400 * kEps);
  }
}

TEST(Intersection, OfAPolygonWithItselfIsThePolygon) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const std::vector<Vec2> a = randomConvex(random, 8);
    std::vector<Vec2> noisy = a;
    for (Vec2& p : noisy) p = p + test::polar(0.5 * kEps, random.in(0, 1));
    const double area = signedArea(a);
    if (area < 1e-3) continue;
    EXPECT_EQ(intersection(a, a, kEps), a);
    EXPECT_NEAR(signedArea(intersection(a, noisy, kEps)), area, 400 * kEps);
  }
}

TEST(Intersection, OfNeighboursIsEmpty) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Vec2> a = randomConvex(random, random.count(3, 12));
    const Vec2 p = random.point();
    const Vec2 q = random.point();
    const std::vector<Vec2> left = clipLeft(a, p, q, kEps);
    const std::vector<Vec2> right = clipLeft(a, q, p, kEps);
    EXPECT_TRUE(left.empty() || right.empty() || intersection(left, right, kEps).empty());
    EXPECT_FALSE(!left.empty() && !right.empty() && overlap(left, right, kFat));
    EXPECT_NEAR(signedArea(left) + signedArea(right), signedArea(a), 200 * kEps);
  }
}

TEST(Overlap, IsFatIntersection) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const std::vector<Vec2> a = randomConvex(random, random.count(3, 9));
    const std::vector<Vec2> b = randomConvex(random, random.count(3, 9));
    const std::vector<Vec2> common = intersection(a, b, kEps);
    double perimeter = 0;
    for (std::size_t k = 0; k < common.size(); ++k)
      perimeter += distance(common[k], common[(k + 1) % common.size()]);
    const bool isFat = !common.empty() && signedArea(common) > kFat * perimeter;
    EXPECT_EQ(overlap(a, b, kFat), isFat) << i;
    EXPECT_EQ(overlap(b, a, kFat), isFat) << i;
  }
}

TEST(Overlap, TurnsFromContactToOverlapAtTheTolerance) {
  const std::vector<Vec2> a{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const auto shifted = [&](double by) {
    std::vector<Vec2> b = a;
    for (Vec2& p : b) p.x += 100 - by;
    return b;
  };
  EXPECT_FALSE(overlap(a, shifted(0), kFat));
  EXPECT_FALSE(overlap(a, shifted(1.9 * kFat), kFat));
  EXPECT_TRUE(overlap(a, shifted(2.1 * kFat), kFat));
  EXPECT_TRUE(overlap(a, a, kFat));
}

TEST(Intersection, OfPolygonsWithManyCornersHasRoom) {
  std::vector<Vec2> round;
  for (int i = 0; i < 500; ++i) round.push_back(test::polar(50, i / 500.0));
  std::vector<Vec2> moved = round;
  for (Vec2& p : moved) p = p + Vec2{3, 4};
  EXPECT_GT(signedArea(intersection(round, moved, kEps)), 7000);
  EXPECT_TRUE(overlap(round, moved, kFat));
}

TEST(ClipLeft, KeepsWhatIsWithinEps) {
  const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(clipLeft(square, {0, 0}, {1, 0}, kEps), square);
  EXPECT_EQ(clipLeft(square, {0, 0.5 * kEps}, {1, 0.5 * kEps}, kEps), square);
  EXPECT_TRUE(clipLeft(square, {1, 0}, {0, 0}, kEps).empty());
  EXPECT_TRUE(clipLeft(square, {0, 10 - 0.5 * kEps}, {1, 10 - 0.5 * kEps}, kEps).empty());
  EXPECT_EQ(clipLeft(square, {0, 5}, {1, 5}, kEps),
            (std::vector<Vec2>{{10, 5}, {10, 10}, {0, 10}, {0, 5}}));
}

ConvexPart numbered(const std::vector<Vec2>& points) {
  ConvexPart part{points, std::vector<std::int32_t>(points.size())};
  std::iota(part.tags.begin(), part.tags.end(), 0);
  return part;
}

TEST(SplitConvex, GivesHalvesThatShareTheNewSideBitForBit) {
  Random random(6);
  for (int i = 0; i < 3000; ++i) {
    const ConvexPart part = numbered(randomConvex(random, random.count(3, 10)));
    const Vec2 a = random.point();
    const Vec2 b = random.point();
    const ConvexHalves halves = splitConvex(part, a, b, 77, kEps);
    EXPECT_EQ(halves.left.points.empty() ? 0 : signedArea(halves.left.points),
              halves.left.points.empty() ? 0 : signedArea(clipLeft(part.points, a, b, kEps)));
    EXPECT_NEAR(signedArea(halves.left.points) + signedArea(halves.right.points),
                signedArea(part.points), 200 * kEps);
    if (halves.left.points.empty() || halves.right.points.empty()) continue;
    const auto newSide = [](const ConvexPart& half) {
      std::vector<std::pair<Vec2, Vec2>> sides;
      for (std::size_t k = 0; k < half.tags.size(); ++k) {
        if (half.tags[k] == 77)
          sides.emplace_back(half.points[k], half.points[(k + 1) % half.points.size()]);
      }
      return sides;
    };
    ASSERT_EQ(newSide(halves.left).size(), 1U);
    ASSERT_EQ(newSide(halves.right).size(), 1U);
    EXPECT_EQ(newSide(halves.left)[0].first, newSide(halves.right)[0].second);
    EXPECT_EQ(newSide(halves.left)[0].second, newSide(halves.right)[0].first);
  }
}

TEST(SplitConvex, KeepsTheTagsOfOldSides) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const ConvexPart part = numbered(randomConvex(random, random.count(3, 10)));
    const ConvexHalves halves = splitConvex(part, random.point(), random.point(), 77, kEps);
    for (const ConvexPart& half : {halves.left, halves.right}) {
      ASSERT_EQ(half.points.size(), half.tags.size());
      for (std::size_t k = 0; k < half.tags.size(); ++k) {
        if (half.tags[k] == 77) continue;
        const auto old = static_cast<std::size_t>(half.tags[k]);
        const Vec2 p = part.points[old];
        const Vec2 q = part.points[(old + 1) % part.points.size()];
        EXPECT_LT(test::distanceTo(half.points[k], p, q), kEps);
        EXPECT_LT(test::distanceTo(half.points[(k + 1) % half.points.size()], p, q), kEps);
      }
    }
  }
}

TEST(SplitConvex, AlongCornersAddsNoPoint) {
  const ConvexPart square = numbered({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const ConvexHalves halves = splitConvex(square, {0, 0}, {10, 10}, 9, kEps);
  EXPECT_EQ(halves.left.points, (std::vector<Vec2>{{0, 0}, {10, 10}, {0, 10}}));
  EXPECT_EQ(halves.left.tags, (std::vector<std::int32_t>{9, 2, 3}));
  EXPECT_EQ(halves.right.points, (std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10}}));
  EXPECT_EQ(halves.right.tags, (std::vector<std::int32_t>{0, 1, 9}));
}

TEST(SplitConvex, AlongASideLeavesAllOnOneSide) {
  const ConvexPart square = numbered({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const ConvexHalves halves = splitConvex(square, {3, 0}, {4, 0}, 9, kEps);
  EXPECT_EQ(halves.left.points, square.points);
  EXPECT_EQ(halves.left.tags, square.tags);
  EXPECT_TRUE(halves.right.points.empty());
  EXPECT_TRUE(splitConvex(square, {4, 0}, {3, 0}, 9, kEps).left.points.empty());
}

}  // namespace
}  // namespace kiri
