// Every line that a construction gives is folded along, and what must coincide does.
// SPDX-License-Identifier: MIT
#include "editor/snap/constructions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/support/random_steps.h"

namespace kiri::testing {
namespace {

constexpr double kResolution = 1e-7;  // mm

/// Reflection by the matrix of the direction's double angle: not how the library does it.
Vec2 folded(Vec2 p, const Line2& line) {
  const double angle = 2 * std::atan2(line.to.y - line.from.y, line.to.x - line.from.x);
  const Vec2 d = p - line.from;
  return line.from + Vec2{std::cos(angle) * d.x + std::sin(angle) * d.y,
                          std::sin(angle) * d.x - std::cos(angle) * d.y};
}

double away(Vec2 p, const Line2& line) {
  return std::abs(cross(line.to - line.from, p - line.from)) / distance(line.from, line.to);
}

Line2 folded(const Line2& l, const Line2& line) {
  return {folded(l.from, line), folded(l.to, line)};
}

/// How far the ends of the one line are from the other.
double away(const Line2& a, const Line2& b) { return std::max(away(a.from, b), away(a.to, b)); }

struct Given {
  Vec2 p, q, r;
  Line2 l, m;
};

Given randomGiven(test::Random& random) {
  const auto point = [&] { return Vec2{random.between(-100, 100), random.between(-100, 100)}; };
  const auto line = [&] {
    Line2 out{point(), point()};
    while (distance(out.from, out.to) < 20) out.to = point();
    return out;
  };
  return {point(), point(), point(), line(), line()};
}

using Operation = std::function<std::vector<Line2>(const Given&)>;

std::vector<Operation> operations() {
  return {[](const Given& g) { return throughPoints(g.p, g.q, kResolution); },
          [](const Given& g) { return pointOntoPoint(g.p, g.q, kResolution); },
          [](const Given& g) { return lineOntoLine(g.l, g.m, kResolution); },
          [](const Given& g) { return squareThrough(g.p, g.l, kResolution); },
          [](const Given& g) { return pointOntoLineThrough(g.p, g.l, g.q, kResolution); },
          [](const Given& g) { return pointsOntoLines(g.p, g.l, g.q, g.m, kResolution); },
          [](const Given& g) { return pointOntoLineSquareTo(g.p, g.l, g.m, kResolution); },
          [](const Given& g) { return bisectorOf(g.p, g.q, g.r, kResolution); }};
}

TEST(Constructions, EveryLineDoesWhatItMust) {
  test::Random random(1);
  std::vector<int> counts(8);
  for (int i = 0; i < 3000; ++i) {
    const Given g = randomGiven(random);
    const auto all = operations();
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (const Line2& f : all[k](g)) {
        ++counts[k];
        ASSERT_GT(distance(f.from, f.to), 1) << "operation " << k + 1;
        // A line far away is known as well as its distance allows.
        const double slack = 1e-9 * (1 + 1e-3 * length(f.from));
        switch (k) {
          case 0:
            EXPECT_LE(std::max(away(g.p, f), away(g.q, f)), slack);
            break;
          case 1:
            EXPECT_LE(distance(folded(g.p, f), g.q), slack);
            break;
          case 2:
            EXPECT_LE(away(folded(g.l, f), g.m), slack * 10);
            break;
          case 3:
            EXPECT_LE(away(g.p, f), slack);
            EXPECT_LE(away(folded(g.l, f), g.l), slack);
            break;
          case 4:
            EXPECT_LE(away(folded(g.p, f), g.l), slack);
            EXPECT_LE(away(g.q, f), slack);
            break;
          case 5:
            EXPECT_LE(away(folded(g.p, f), g.l), kResolution);
            EXPECT_LE(away(folded(g.q, f), g.m), kResolution);
            break;
          case 6:
            EXPECT_LE(away(folded(g.p, f), g.l), slack);
            EXPECT_LE(away(folded(g.m, f), g.m), slack);
            break;
          default:
            EXPECT_LE(distance(f.from, g.q), slack);
            EXPECT_LE(away(folded(g.p, f), {g.q, g.r}), slack);
            EXPECT_GT(dot(folded(g.p, f) - g.q, g.r - g.q), 0) << "onto the ray, not behind it";
        }
      }
    }
  }
  EXPECT_EQ(counts[0], 3000);
  EXPECT_EQ(counts[1], 3000);
  EXPECT_EQ(counts[2], 6000);
  EXPECT_EQ(counts[3], 3000);
  EXPECT_GT(counts[4], 2000);
  EXPECT_GE(counts[5], 3000) << "a cubic has a zero";
  EXPECT_EQ(counts[6], 3000);
  EXPECT_EQ(counts[7], 3000);
}

/// Lines are the same when the ends of each lie on the other, as seen from where things are.
bool isAmong(const Line2& line, const std::vector<Line2>& lines, double slack) {
  return std::any_of(lines.begin(), lines.end(), [&](const Line2& other) {
    return away(line, other) <= slack && away(other, line) <= slack;
  });
}

TEST(Constructions, TurningAndMovingEverythingTurnsAndMovesTheLines) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Given g = randomGiven(random);
    const double angle = random.between(-M_PI, M_PI);
    const Vec2 by{random.between(-500, 500), random.between(-500, 500)};
    const bool isMirrored = random.chance(0.5);
    const auto moved = [&](Vec2 p) {
      if (isMirrored) p.x = -p.x;
      return Vec2{std::cos(angle) * p.x - std::sin(angle) * p.y,
                  std::sin(angle) * p.x + std::cos(angle) * p.y} +
             by;
    };
    const auto movedLine = [&](const Line2& l) { return Line2{moved(l.from), moved(l.to)}; };
    const Given h{moved(g.p), moved(g.q), moved(g.r), movedLine(g.l), movedLine(g.m)};
    const auto all = operations();
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::vector<Line2> here = all[k](g);
      const std::vector<Line2> there = all[k](h);
      ASSERT_EQ(here.size(), there.size()) << "operation " << k + 1;
      for (const Line2& line : here) {
        const Line2 image = movedLine(line);
        EXPECT_TRUE(isAmong(image, there, 1e-6 * (1 + 1e-2 * length(line.from))))
            << "operation " << k + 1;
      }
    }
  }
}

/// The same number of ways by walking round all directions of the fold, for the sixth operation.
int waysByWalking(const Given& g) {
  constexpr int kSteps = 200000;
  const auto side = [&](double angle, double& nearPole) {
    const Vec2 n{std::cos(angle), std::sin(angle)};
    const Vec2 u = perpendicular(normalized(g.l.to - g.l.from));
    const Vec2 v = perpendicular(normalized(g.m.to - g.m.from));
    // The fold that takes p onto l, and by how much q misses m then.
    const double c = dot(n, g.p) + dot(u, g.l.from - g.p) / (2 * dot(n, u));
    nearPole = std::abs(dot(n, u));
    return dot(v, g.q + n * (2 * (c - dot(n, g.q))) - g.m.from);
  };
  int ways = 0;
  double pole = 0;
  double last = side(0, pole);
  for (int i = 1; i <= kSteps; ++i) {
    const double now = side(M_PI * i / kSteps, pole);
    if ((now < 0) != (last < 0) && pole > 1e-3 && std::abs(now - last) < 50) ++ways;
    last = now;
  }
  return ways;
}

TEST(PointsOntoLines, FindsAsManyLinesAsThereAre) {
  test::Random random(3);
  int three = 0;
  for (int i = 0; i < 60; ++i) {
    const Given g = randomGiven(random);
    const std::vector<Line2> lines = pointsOntoLines(g.p, g.l, g.q, g.m, kResolution);
    const Vec2 u = normalized(g.l.to - g.l.from);
    const bool isNearPole = std::any_of(lines.begin(), lines.end(), [&](const Line2& f) {
      return std::abs(dot(perpendicular(normalized(f.to - f.from)), perpendicular(u))) < 0.01;
    });
    if (isNearPole) continue;  // walking loses such folds
    EXPECT_EQ(static_cast<int>(lines.size()), waysByWalking(g)) << i;
    if (lines.size() == 3) ++three;
  }
  EXPECT_GT(three, 5);
}

/// Common tangents of x^2 = 4y and (y - k)^2 = 4p (x - h): their slopes are the zeros of
/// m^3 - h m^2 + k m + p.
std::vector<double> slopesOf(double h, double k, double p) {
  std::vector<double> slopes;
  for (const Line2& line : pointsOntoLines({0, 1}, {{-3, -1}, {3, -1}}, {p + h, k},
                                           {{h - p, -3}, {h - p, 3}}, kResolution)) {
    slopes.push_back((line.to.y - line.from.y) / (line.to.x - line.from.x));
  }
  std::sort(slopes.begin(), slopes.end());
  return slopes;
}

void expectSlopes(const std::vector<double>& found, const std::vector<double>& expected,
                  double slack) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], slack);
}

TEST(PointsOntoLines, SolvesCubicEquations) {
  expectSlopes(slopesOf(0, 0, 2), {-std::cbrt(2.0)}, 1e-12);  // the cube is doubled
  expectSlopes(slopesOf(2, -5, 6), {-2, 1, 3}, 1e-12);
  expectSlopes(slopesOf(0, -3, 2), {-2, 1}, 1e-6);  // a double zero is one line
  expectSlopes(slopesOf(3, 3, -1), {1}, 1e-4);      // a threefold one too
  // A third of 60 degrees: 4c^3 - 3c = cos(60), c = cos(20), cos(140), cos(260).
  expectSlopes(slopesOf(0, -0.75, -0.125),
               {std::cos(140 * M_PI / 180), std::cos(260 * M_PI / 180), std::cos(20 * M_PI / 180)},
               1e-10);
}

TEST(PointsOntoLines, APointThatLiesOnItsLineMayStayOrSlide) {
  // The fold goes through the point, or is square to its line.
  const Line2 l{{0, 0}, {10, 0}};
  const Line2 m{{0, 5}, {10, 5}};
  const std::vector<Line2> lines = pointsOntoLines({3, 0}, l, {7, 4}, m, kResolution);
  ASSERT_FALSE(lines.empty());
  for (const Line2& f : lines) {
    EXPECT_LE(away(folded(Vec2{3, 0}, f), l), 1e-9);
    EXPECT_LE(away(folded(Vec2{7, 4}, f), m), 1e-9);
  }
  // Both on their lines: through both, and square to either line through the other point.
  const std::vector<Line2> all =
      pointsOntoLines({0, 0}, l, {10, 10}, {{10, 10}, {10, 0}}, kResolution);
  EXPECT_EQ(all.size(), 3U);
  EXPECT_TRUE(isAmong({{0, 0}, {10, 10}}, all, 1e-9));
  EXPECT_TRUE(isAmong({{10, 10}, {10, 0}}, all, 1e-9));
  EXPECT_TRUE(isAmong({{0, 0}, {10, 0}}, all, 1e-9));
}

TEST(PointsOntoLines, KnowsWhenThereIsNoneOrNoEnd) {
  const Line2 l{{0, 0}, {10, 0}};
  EXPECT_TRUE(pointsOntoLines({2, 5}, l, {2, 5}, l, kResolution).empty()) << "the same wish twice";
  EXPECT_TRUE(pointsOntoLines({2, 5}, l, {2, 5}, {{10, 0}, {-5, 0}}, kResolution).empty());
  EXPECT_TRUE(pointsOntoLines({2, 5}, l, {2, 5}, {{0, 1}, {10, 1}}, kResolution).empty())
      << "one point cannot be on two parallels";
  EXPECT_TRUE(pointsOntoLines({2, 5}, l, {3, 3}, {{1, 1}, {1, 1}}, kResolution).empty());
  const std::vector<Line2> one = pointsOntoLines({2, 5}, l, {2, 5}, {{7, -3}, {7, 9}}, kResolution);
  ASSERT_EQ(one.size(), 1U) << "to where the lines cross";
  EXPECT_LE(distance(folded(Vec2{2, 5}, one.front()), {7, 0}), 1e-9);
  // Parallels leave at most two.
  test::Random random(4);
  int two = 0;
  for (int i = 0; i < 500; ++i) {
    Given g = randomGiven(random);
    g.m = {g.l.from + Vec2{5, 9}, g.l.to + Vec2{5, 9}};
    const std::vector<Line2> lines = pointsOntoLines(g.p, g.l, g.q, g.m, kResolution);
    EXPECT_LE(lines.size(), 2U);
    if (lines.size() == 2) ++two;
    for (const Line2& f : lines) EXPECT_LE(away(folded(g.q, f), g.m), kResolution);
  }
  EXPECT_GT(two, 50);
}

TEST(LineOntoLine, ParallelsHaveTheLineBetweenThem) {
  const Line2 l{{0, 0}, {10, 0}};
  for (const Line2& m : {Line2{{3, 4}, {8, 4}}, Line2{{8, 4}, {3, 4}}}) {
    const std::vector<Line2> lines = lineOntoLine(l, m, kResolution);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(isAmong({{0, 2}, {1, 2}}, lines, 1e-12));
  }
  EXPECT_TRUE(lineOntoLine(l, {{20, 0}, {30, 0}}, kResolution).empty()) << "it lies there already";
  EXPECT_TRUE(lineOntoLine(l, {{1, 1}, {1, 1}}, kResolution).empty());
}

TEST(LineOntoLine, TheFirstLineLiesBetweenTheDirections) {
  const std::vector<Line2> lines = lineOntoLine({{0, 0}, {10, 0}}, {{0, 0}, {0, 10}}, kResolution);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(isAmong({{0, 0}, {1, 1}}, {lines[0]}, 1e-12));
  EXPECT_TRUE(isAmong({{0, 0}, {1, -1}}, {lines[1]}, 1e-12));
}

TEST(LineOntoLine, LinesThatAreAlmostParallelAreHalvedWell) {
  for (const double rise : {1e-2, 1e-4, 1e-6}) {
    const Line2 l{{0, 0}, {100, 0}};
    const Line2 m{{0, 10}, {100, 10 + rise}};
    const std::vector<Line2> lines = lineOntoLine(l, m, kResolution);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_LE(away(folded(l, lines[0]), m), 1e-10);
  }
}

TEST(PointOntoLineThrough, TheCircleMeetsTheLineTwiceOnceOrNever) {
  const Line2 l{{-5, 0}, {5, 0}};
  EXPECT_EQ(pointOntoLineThrough({6, 3}, l, {0, 3}, kResolution).size(), 2U);
  EXPECT_EQ(pointOntoLineThrough({3, 3}, l, {0, 3}, kResolution).size(), 1U);
  EXPECT_EQ(pointOntoLineThrough({3, 3 + 1e-9}, l, {0, 3}, kResolution).size(), 1U);
  EXPECT_EQ(pointOntoLineThrough({2, 3}, l, {0, 3}, kResolution).size(), 0U);
  EXPECT_TRUE(pointOntoLineThrough({0, 3}, l, {0, 3}, kResolution).empty()) << "it cannot move";
  // A point that lies on the line: the fold that leaves it there, and the other.
  const std::vector<Line2> lines = pointOntoLineThrough({4, 0}, l, {0, 3}, kResolution);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(isAmong({{0, 3}, {4, 0}}, lines, 1e-9));
  EXPECT_TRUE(isAmong({{0, 3}, {0, 0}}, lines, 1e-9));
}

TEST(PointOntoLineSquareTo, ParallelsHaveNone) {
  EXPECT_TRUE(
      pointOntoLineSquareTo({1, 2}, {{0, 0}, {9, 0}}, {{0, 5}, {7, 5}}, kResolution).empty());
  const std::vector<Line2> lines =
      pointOntoLineSquareTo({4, 2}, {{0, 0}, {0, 9}}, {{0, 5}, {7, 5}}, kResolution);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(isAmong({{2, 0}, {2, 1}}, lines, 1e-12));
}

TEST(Constructions, CoincidentPointsGiveNoLine) {
  EXPECT_TRUE(throughPoints({1, 1}, {1, 1}, kResolution).empty());
  EXPECT_TRUE(pointOntoPoint({1, 1}, {1, 1 + 1e-9}, kResolution).empty());
  EXPECT_TRUE(bisectorOf({1, 1}, {1, 1}, {5, 5}, kResolution).empty());
  EXPECT_TRUE(squareThrough({1, 1}, {{3, 3}, {3, 3}}, kResolution).empty());
}

TEST(BisectorOf, HalvesAlsoStraightAndVanishingAngles) {
  const auto direction = [](Vec2 a, Vec2 b) {
    const Line2 l = bisectorOf(a, {0, 0}, b, kResolution).front();
    return normalized(l.to - l.from);
  };
  EXPECT_LE(distance(direction({4, 0}, {0, 9}), normalized(Vec2{1, 1})), 1e-15);
  EXPECT_LE(distance(direction({4, 0}, {9, 0}), {1, 0}), 1e-15);
  EXPECT_NEAR(std::abs(direction({4, 0}, {-9, 0}).y), 1, 1e-15);
  EXPECT_GT(direction({4, 1e-6}, {-9, 1e-6}).y, 0.999999);
}

TEST(Mirrored, TwiceIsNothingAndTheMirrorStays) {
  test::Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Given g = randomGiven(random);
    EXPECT_LE(distance(mirrored(g.p, g.l), folded(g.p, g.l)), 1e-10);
    EXPECT_LE(distance(mirrored(mirrored(g.p, g.l), g.l), g.p), 1e-10);
    EXPECT_LE(away(mirrored(g.l, g.l), g.l), 1e-10);
    EXPECT_LE(distance(mirrored(g.m, g.l).from, mirrored(g.m.from, g.l)), 0);
    const Vec2 foot = projectedOnto(g.p, g.l);
    EXPECT_LE(away(foot, g.l), 1e-10);
    EXPECT_NEAR(dot(foot - g.p, g.l.to - g.l.from), 0, 1e-8);
  }
  EXPECT_EQ(mirrored(Vec2{3, 4}, {{1, 1}, {1, 1}}), (Vec2{3, 4}));
  EXPECT_EQ(projectedOnto({3, 4}, {{1, 1}, {1, 1}}), (Vec2{1, 1}));
}

}  // namespace
}  // namespace kiri::testing
