// Path data and shapes of SVG.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "io/patterns/svg_numbers.h"

namespace kiri {
namespace {

void expectNear(Vec2 a, Vec2 b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
}

/// Holds when both data draw the same.
void expectSame(const std::string& a, const std::string& b) {
  const SvgOutline one = svgPathOf(a);
  const SvgOutline other = svgPathOf(b);
  EXPECT_TRUE(one.isWhole) << a;
  EXPECT_TRUE(other.isWhole) << b;
  ASSERT_EQ(one.chains.size(), other.chains.size()) << a;
  for (std::size_t i = 0; i < one.chains.size(); ++i) {
    const SvgChain& p = one.chains[i];
    const SvgChain& q = other.chains[i];
    EXPECT_EQ(p.isClosed, q.isClosed) << a;
    ASSERT_EQ(p.arcs.size(), q.arcs.size()) << a;
    for (std::size_t k = 0; k < p.arcs.size(); ++k) {
      for (const double t : {0.0, 0.3, 1.0}) {
        expectNear(pointAt(p.arcs[k], t), pointAt(q.arcs[k], t));
      }
    }
  }
}

TEST(SvgPath, AbsoluteAndRelativeCommandsDrawTheSame) {
  expectSame("M1 2L4 6H7V9Z", "m1 2l3 4h3v3z");
  expectSame("M1 1C2 2 3 0 4 1S6 0 7 1", "m1 1c1 1 2-1 3 0s2-1 3 0");
  expectSame("M1 1Q2 3 4 1T7 1", "m1 1q1 2 3 0t3 0");
  expectSame("M1 1A2 3 30 0 1 4 2", "m1 1a2 3 30 0 1 3 1");
  expectSame("M1 1 2 2 3 1M5 5 6 6", "m1 1 1 1 1-1m2 4 1 1");
  expectSame("M1 1L2 2ZL0 5", "m1 1l1 1zl-1 4");
}

TEST(SvgPath, DenseNumbersAreToldApart) {
  expectSame("M1-2.5.5.5L1e1-2e-1", "M 1 -2.5 L .5 .5 L 10 -0.2");
  expectSame("M0 0a1 1 0 01.5.5", "M 0,0 a 1,1 0 0 1 0.5,0.5");
  expectSame("M0 0a1 1 0 101-1", "M 0,0 a 1,1 0 1 0 1,-1");
}

TEST(SvgPath, SmoothPiecesMirrorTheControlBefore) {
  expectSame("M0 0C1 2 3 2 4 0S7-2 8 0", "M0 0C1 2 3 2 4 0C5-2 7-2 8 0");
  expectSame("M0 0S7-2 8 0", "M0 0C0 0 7-2 8 0");
  expectSame("M0 0Q2 2 4 0T8 0T12 0", "M0 0Q2 2 4 0Q6-2 8 0Q10 2 12 0");
  expectSame("M0 0L4 0T8 0", "M0 0L4 0Q4 0 8 0");
}

TEST(SvgPath, EndsWhereTheDamageStarts) {
  for (const char* text :
       {"M0 0L1 1L2", "M0 0L1 1X2 2", "M0 0L1 1 2 x", "M0 0L1 1A1 1 0 2 0 3 3"}) {
    const SvgOutline outline = svgPathOf(text);
    EXPECT_FALSE(outline.isWhole) << text;
    ASSERT_EQ(outline.chains.size(), 1U) << text;
    EXPECT_EQ(outline.chains[0].arcs.size(), 1U) << text;
  }
  EXPECT_FALSE(svgPathOf("L1 1").isWhole);
  EXPECT_FALSE(svgPathOf("M0 0Z1 1").isWhole);
}

/// The largest distance of the chain's points from the ellipse about the origin, axes along x, y.
double missOf(const std::vector<Arc>& arcs, Vec2 radii) {
  double worst = 0;
  for (const Arc& arc : arcs) {
    for (double t = 0; t <= 1; t += 0.05) {
      const Vec2 p = pointAt(arc, t);
      worst = std::max(worst, std::abs(std::hypot(p.x / radii.x, p.y / radii.y) - 1));
    }
  }
  return worst;
}

TEST(SvgPath, ArcsLieOnTheirEllipse) {
  for (const bool isLarge : {false, true}) {
    for (const bool isPositive : {false, true}) {
      // From (3, 0) to (0, 2) on the ellipse about the origin, or on its twin about (3, 2).
      std::vector<Arc> arcs;
      appendSvgArc(arcs, {3, 0}, {0, 2}, {3, 2}, 0, isLarge, isPositive);
      const bool isOwn = isLarge != isPositive;
      const Vec2 centre = isOwn ? Vec2{0, 0} : Vec2{3, 2};
      for (Arc& arc : arcs) {
        arc = Arc::cubic(arc.start - centre, arc.control1 - centre, arc.control2 - centre,
                         arc.end - centre);
      }
      EXPECT_LT(missOf(arcs, {3, 2}), 5e-6) << isLarge << isPositive;
      double turned = 0;
      for (const Arc& arc : arcs) turned += doubleArea(arc);
      const double quarter = std::numbers::pi / 2 * 6;
      EXPECT_NEAR(std::abs(turned), isLarge ? 3 * quarter : quarter, 1e-3);
      EXPECT_EQ(turned > 0, isPositive);
    }
  }
}

TEST(SvgPath, RadiiTooSmallGrowAndTurnedAxesTurn) {
  std::vector<Arc> arcs;
  appendSvgArc(arcs, {-2, 0}, {2, 0}, {1, 1}, 30, false, true);
  EXPECT_LT(missOf(arcs, {2, 2}), 5e-6);
  arcs.clear();
  const double half = std::sqrt(0.5);
  appendSvgArc(arcs, {3 * half, 3 * half}, {-3 * half, -3 * half}, {3, 1}, 45, false, true);
  const SvgMatrix back = *svgTransformOf("rotate(-45)");
  for (Arc& arc : arcs) {
    arc = Arc::cubic(back.apply(arc.start), back.apply(arc.control1), back.apply(arc.control2),
                     back.apply(arc.end));
  }
  EXPECT_LT(missOf(arcs, {3, 1}), 5e-6);
}

TEST(SvgPath, ShapesHaveTheirAreas) {
  const auto areaOf = [](const SvgChain& chain) {
    double twice = 0;
    for (const Arc& arc : chain.arcs) twice += doubleArea(arc);
    EXPECT_EQ(chain.arcs.front().start, chain.arcs.back().end);
    return twice / 2;
  };
  EXPECT_DOUBLE_EQ(areaOf(svgRectangle({1, 2}, {3, 4}, {0, 0})), 12);
  EXPECT_NEAR(areaOf(svgRectangle({1, 2}, {3, 4}, {1, 0.5})), 12 - (4 - std::numbers::pi) * 0.5,
              1e-5);
  EXPECT_NEAR(areaOf(svgRectangle({1, 2}, {4, 4}, {9, 9})), 4 * std::numbers::pi, 1e-4);
  EXPECT_NEAR(areaOf(svgEllipse({7, 7}, {2, 3})), 6 * std::numbers::pi, 1e-4);
  EXPECT_DOUBLE_EQ(areaOf(svgPointsOf("0,0 4,0,4 3", true).chains[0]), 6);
}

TEST(SvgTransform, AllKindsAreReadOneAfterTheOther) {
  expectNear(svgTransformOf("translate(1,2) scale(3)")->apply({1, 1}), {4, 5});
  expectNear(svgTransformOf("scale(3, -1)translate(1)")->apply({1, 1}), {6, -1});
  expectNear(svgTransformOf(" rotate(90) ")->apply({1, 0}), {0, 1});
  expectNear(svgTransformOf("rotate(180 1 2)")->apply({1, 0}), {1, 4});
  expectNear(svgTransformOf("rotate(-450,1,2)")->apply({2, 2}), {1, 1});
  expectNear(svgTransformOf("rotate(30)")->apply({2, 0}), {std::sqrt(3), 1});
  expectNear(svgTransformOf("skewX(45)")->apply({0, 1}), {1, 1});
  expectNear(svgTransformOf("skewY(45)")->apply({1, 0}), {1, 1});
  expectNear(svgTransformOf("matrix(1 2 3 4 5 6)")->apply({1, 1}), {9, 12});
  EXPECT_EQ(*svgTransformOf(""), SvgMatrix{});
  for (const char* text : {"spin(3)", "scale(1", "scale", "translate()", "matrix(1 2 3)",
                           "scale(1 2 3)", "rotate(1 2)", "rotate(a)"}) {
    EXPECT_FALSE(svgTransformOf(text)) << text;
  }
}

}  // namespace
}  // namespace kiri
