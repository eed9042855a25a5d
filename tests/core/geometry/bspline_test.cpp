// Bezier pieces of splines against the recursion of Cox and de Boor.
// SPDX-License-Identifier: MIT
#include "core/geometry/bspline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace kiri {
namespace {

/// Basis function of order k (degree k - 1), straight from the definition.
double basis(const std::vector<double>& knots, std::size_t i, int k, double t) {
  if (k == 1) return knots[i] <= t && t < knots[i + 1] ? 1 : 0;
  const std::size_t j = i + static_cast<std::size_t>(k);
  double sum = 0;
  if (knots[j - 1] > knots[i])
    sum += (t - knots[i]) / (knots[j - 1] - knots[i]) * basis(knots, i, k - 1, t);
  if (knots[j] > knots[i + 1])
    sum += (knots[j] - t) / (knots[j] - knots[i + 1]) * basis(knots, i + 1, k - 1, t);
  return sum;
}

Vec2 coxDeBoor(const std::vector<Vec2>& controls, const std::vector<double>& knots, double t) {
  Vec2 sum;
  for (std::size_t i = 0; i < controls.size(); ++i) sum = sum + controls[i] * basis(knots, i, 4, t);
  return sum;
}

std::vector<Vec2> randomControls(std::mt19937& engine, std::size_t n) {
  std::uniform_real_distribution<> in(0, 100);
  std::vector<Vec2> result(n);
  for (Vec2& p : result) p = {in(engine), in(engine)};
  return result;
}

/// Largest distance of pieces from the spline whose parameter runs from `first` with 1 for each
/// piece.
double strayOf(const std::vector<Arc>& pieces, const std::vector<Vec2>& controls,
               const std::vector<double>& knots, double first) {
  double worst = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (int k = 0; k < 16; ++k) {
      const double t = k / 16.0;
      const Vec2 expected = coxDeBoor(controls, knots, first + static_cast<double>(i) + t);
      worst = std::max(worst, distance(pointAt(pieces[i], t), expected));
    }
  }
  return worst;
}

void expectJoined(const std::vector<Arc>& pieces) {
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i].start, pieces[i - 1].end);
    EXPECT_LT(
        distance(pieces[i].control1 - pieces[i].start, pieces[i - 1].end - pieces[i - 1].control2) /
            (1 + length(pieces[i].control1 - pieces[i].start)),
        100.0);
  }
}

TEST(OpenSpline, FreeEndsFollowCoxDeBoor) {
  std::mt19937 engine(1);
  for (std::size_t n = 4; n < 20; ++n) {
    const std::vector<Vec2> controls = randomControls(engine, n);
    std::vector<double> knots;
    for (std::size_t i = 0; i < n + 4; ++i) knots.push_back(static_cast<double>(i));
    const std::vector<Arc> pieces = openSpline(controls, SplineEnds::Free);
    ASSERT_EQ(pieces.size(), n - 3);
    EXPECT_LT(strayOf(pieces, controls, knots, 3), 1e-12);
    expectJoined(pieces);
  }
}

TEST(OpenSpline, ClampedEndsFollowCoxDeBoor) {
  std::mt19937 engine(2);
  for (std::size_t n = 4; n < 20; ++n) {
    const std::vector<Vec2> controls = randomControls(engine, n);
    const double last = static_cast<double>(n - 3);
    std::vector<double> knots{0, 0, 0};
    for (std::size_t i = 0; i <= n - 3; ++i) knots.push_back(static_cast<double>(i));
    knots.insert(knots.end(), 3, last);
    const std::vector<Arc> pieces = openSpline(controls, SplineEnds::Clamped);
    ASSERT_EQ(pieces.size(), n - 3);
    EXPECT_LT(strayOf(pieces, controls, knots, 0), 1e-12);
    EXPECT_EQ(pieces.front().start, controls.front());
    EXPECT_EQ(pieces.back().end, controls.back());
    expectJoined(pieces);
  }
}

TEST(OpenSpline, OfFourClampedControlsIsTheirBezierCurve) {
  const std::vector<Vec2> c{{0, 0}, {10, 30}, {40, 31}, {50, 0.1}};
  EXPECT_EQ(openSpline(c, SplineEnds::Clamped),
            std::vector<Arc>{Arc::cubic(c[0], c[1], c[2], c[3])});
}

TEST(ClosedSpline, FollowsCoxDeBoorAllAround) {
  std::mt19937 engine(3);
  for (std::size_t n = 3; n < 20; ++n) {
    const std::vector<Vec2> controls = randomControls(engine, n);
    std::vector<Vec2> unrolled = controls;
    for (std::size_t i = 0; i < 3; ++i) unrolled.push_back(controls[i]);
    std::vector<double> knots;
    for (std::size_t i = 0; i < unrolled.size() + 4; ++i) knots.push_back(static_cast<double>(i));
    const std::vector<Arc> pieces = closedSpline(controls);
    ASSERT_EQ(pieces.size(), n);
    EXPECT_LT(strayOf(pieces, unrolled, knots, 3), 1e-12);
    EXPECT_EQ(pieces.back().end, pieces.front().start);
    expectJoined(pieces);
  }
}

TEST(ClosedSpline, MovesWithItsControls) {
  std::mt19937 engine(4);
  std::vector<Vec2> controls = randomControls(engine, 8);
  const std::vector<Arc> pieces = closedSpline(controls);
  for (Vec2& p : controls) p.x = -p.x;
  const std::vector<Arc> mirrored = closedSpline(controls);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ(mirrored[i].start, (Vec2{-pieces[i].start.x, pieces[i].start.y}));
    EXPECT_EQ(mirrored[i].control1, (Vec2{-pieces[i].control1.x, pieces[i].control1.y}));
  }
}

}  // namespace
}  // namespace kiri
