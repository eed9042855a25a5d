// Strokes of the hand as splines, held against the splines they came from.
// SPDX-License-Identifier: MIT
#include "editor/tools/curve_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/bspline.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

std::vector<Arc> arcsOf(const std::vector<Vec2>& controls, bool isClosed) {
  return isClosed ? closedSpline(controls) : openSpline(controls, SplineEnds::Clamped);
}

std::vector<Vec2> sampled(const std::vector<Arc>& arcs, int perArc) {
  std::vector<Vec2> points;
  for (const Arc& arc : arcs) {
    for (int i = 0; i < perArc; ++i)
      points.push_back(pointAt(arc, static_cast<double>(i) / perArc));
  }
  points.push_back(arcs.back().end);
  return points;
}

double farthest(const std::vector<Vec2>& points, const std::vector<Arc>& arcs) {
  double most = 0;
  for (const Vec2 p : points) {
    double nearest = nearestOn(arcs.front(), p).distance;
    for (const Arc& arc : arcs) nearest = std::min(nearest, nearestOn(arc, p).distance);
    most = std::max(most, nearest);
  }
  return most;
}

const std::vector<Vec2> kMargin{{70.8924, 136.9407}, {85.2197, 140.6254},  {100, 140},
                                {110.2573, 133.306}, {116.7564, 119.2283}, {121.1132, 102.8554},
                                {123.2736, 85.074},  {125.5245, 74.1287},  {129.7868, 23.272}};

TEST(CurveFit, AKnownSplineComesBackWithAboutAsManyControls) {
  const std::vector<Vec2> stroke = sampled(arcsOf(kMargin, false), 12);
  const FittedCurve fit = fitCurve(stroke, false, 0.3);
  EXPECT_LE(fit.error, 0.3);
  EXPECT_LE(fit.controls.size(), kMargin.size());
  const std::vector<Arc> arcs = arcsOf(fit.controls, false);
  EXPECT_LE(farthest(stroke, arcs), 0.3 + 1e-9);
  EXPECT_LE(farthest(sampled(arcs, 20), arcsOf(kMargin, false)), 0.35);
  EXPECT_LT(distance(fit.controls.front(), kMargin.front()), 1e-9);
  EXPECT_LT(distance(fit.controls.back(), kMargin.back()), 1e-9);
}

TEST(CurveFit, TheErrorItTellsIsNotLessThanTheTrueOne) {
  Random random(7);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    const bool isClosed = round % 2 == 1;
    std::vector<Vec2> controls;
    const std::size_t count = 4 + random.below(9);
    for (std::size_t i = 0; i < count; ++i) {
      const double turn = 6.28 * static_cast<double>(i) / static_cast<double>(count);
      const double radius = random.between(30, 60);
      controls.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
    std::vector<Vec2> stroke = sampled(arcsOf(controls, isClosed), 15);
    if (isClosed) stroke.pop_back();
    for (Vec2& p : stroke) p = p + Vec2{random.between(-0.2, 0.2), random.between(-0.2, 0.2)};
    const FittedCurve fit = fitCurve(stroke, isClosed, 0.6);
    EXPECT_LE(fit.error, 0.6);
    EXPECT_LE(farthest(stroke, arcsOf(fit.controls, isClosed)), fit.error + 1e-9);
    EXPECT_LE(fit.controls.size(), 4 + count + count / 2);
  }
}

TEST(CurveFit, CornersTakeControlsButEndsStayAndTheLimitHolds) {
  const std::vector<Vec2> stroke{{0, 0}, {50, 50}, {100, 0}, {150, 50}};
  const FittedCurve fit = fitCurve(stroke, false, 1.0);
  EXPECT_LE(fit.error, 1.0);
  const FittedCurve few = fitCurve(stroke, false, 1.0, 5);
  EXPECT_LE(few.controls.size(), 5U);
  EXPECT_GT(few.error, 1.0);
  EXPECT_LE(farthest(stroke, arcsOf(few.controls, false)), few.error + 1e-9);
}

TEST(CurveFit, AStrokeWithoutLengthIsNoCurve) {
  EXPECT_TRUE(fitCurve({}, false, 1).controls.empty());
  EXPECT_TRUE(fitCurve({{3, 4}, {3, 4}, {3, 4}}, false, 1).controls.empty());
  EXPECT_TRUE(fitCurve({{3, 4}}, true, 1).controls.empty());
  EXPECT_EQ(fitCurve({{0, 0}, {10, 0}}, false, 1).controls.size(), 4U);
}

TEST(CurveFit, OneControlMoreStaysNearTheOldCurve) {
  for (const bool isClosed : {false, true}) {
    const std::vector<Arc> old = arcsOf(kMargin, isClosed);
    for (std::size_t i = 0; i < 4 * old.size(); ++i) {
      SCOPED_TRACE(i);
      const double at = (static_cast<double>(i) + 0.5) / 4;
      const std::vector<Vec2> more = withControlAt(kMargin, isClosed, at);
      ASSERT_EQ(more.size(), kMargin.size() + 1);
      const std::vector<Arc> arcs = arcsOf(more, isClosed);
      EXPECT_LT(farthest(sampled(old, 10), arcs), 4.0);
      // The new control is one that can be seen to belong to the place.
      const Vec2 place = pointAt(old[i / 4], at - std::floor(at));
      double nearest = 1e9;
      for (const Vec2 c : more) {
        const bool isNew = std::find(kMargin.begin(), kMargin.end(), c) == kMargin.end();
        if (isNew) nearest = std::min(nearest, distance(c, place));
      }
      EXPECT_LT(nearest, 25.0);
      if (isClosed) continue;
      EXPECT_EQ(more.front(), kMargin.front());
      EXPECT_EQ(more.back(), kMargin.back());
    }
  }
}

}  // namespace
}  // namespace kiri::test
