// Arcs: polynomial identities, areas and lengths against limits, samples that depend on the shape
// only. SPDX-License-Identifier: MIT
#include "core/geometry/cubic.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/core/geometry/shapes.h"

namespace kiri {
namespace {

using test::polyline;
using test::Random;

Vec2 bernstein(const Arc& c, double t) {
  const double s = 1 - t;
  return c.start * (s * s * s) + c.control1 * (3 * s * s * t) + c.control2 * (3 * s * t * t) +
         c.end * (t * t * t);
}

TEST(PointAt, FollowsTheBernsteinPolynomials) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Arc arc = random.cubic();
    const double t = random.in(0, 1);
    EXPECT_LT(distance(pointAt(arc, t), bernstein(arc, t)), 1e-13);
    const double h = 1e-5;
    const Vec2 slope = (bernstein(arc, t + h) - bernstein(arc, t - h)) / (2 * h);
    EXPECT_LT(distance(tangentAt(arc, t), slope), 1e-6);
  }
}

TEST(PointAt, IsExactAtTheEnds) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    for (const Arc& arc : {random.cubic(), random.line()}) {
      EXPECT_EQ(pointAt(arc, 0), arc.start);
      EXPECT_EQ(pointAt(arc, 1), arc.end);
    }
  }
}

TEST(Part, IsTheSameCurveOnItsInterval) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Arc arc = i % 2 == 0 ? random.cubic() : random.line();
    const double t0 = random.in(0, 0.9);
    const double t1 = random.in(t0, 1);
    const Arc piece = part(arc, t0, t1);
    EXPECT_EQ(piece.start, pointAt(arc, t0));
    EXPECT_EQ(piece.end, pointAt(arc, t1));
    for (const double s : {0.0, 0.3, 0.7, 1.0}) {
      EXPECT_LT(distance(pointAt(piece, s), pointAt(arc, t0 + (t1 - t0) * s)), 1e-12);
    }
  }
}

TEST(Part, OfTheWholeIsTheArc) {
  Random random(4);
  const Arc arc = random.cubic();
  EXPECT_EQ(part(arc, 0, 1), arc);
}

TEST(Part, NeighboursShareTheirJoint) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Arc arc = random.cubic();
    const double t = random.in(0.01, 0.99);
    EXPECT_EQ(part(arc, 0, t).end, part(arc, t, 1).start);
  }
}

TEST(Reversed, RunsBackwardsAndTwiceIsNothing) {
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    const Arc arc = random.cubic();
    EXPECT_EQ(reversed(reversed(arc)), arc);
    EXPECT_LT(distance(pointAt(reversed(arc), 0.3), pointAt(arc, 0.7)), 1e-13);
    EXPECT_NEAR(doubleArea(reversed(arc)), -doubleArea(arc), 1e-9);
  }
}

TEST(StartDirection, IsTheTangentEvenWhereControlsFallTogether) {
  const Vec2 up{0, 1};
  EXPECT_EQ(startDirection(Arc::cubic({0, 0}, {0, 2}, {5, 5}, {9, 0})), up);
  EXPECT_EQ(startDirection(Arc::cubic({0, 0}, {0, 0}, {0, 5}, {9, 0})), up);
  EXPECT_EQ(startDirection(Arc::cubic({0, 0}, {0, 0}, {0, 0}, {0, 3})), up);
  EXPECT_EQ(startDirection(Arc::line({3, 0}, {3, 8})), up);
}

TEST(DoubleArea, IsThatOfADensePolyline) {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const Arc arc = random.cubic();
    // The error of a polyline falls with the square of the step: extrapolate (Richardson).
    const auto fan = [&](int pieces) {
      const std::vector<Vec2> p = polyline(arc, pieces);
      double sum = 0;
      for (std::size_t k = 0; k + 1 < p.size(); ++k) sum += cross(p[k], p[k + 1]);
      return sum;
    };
    const double limit = (4 * fan(2000) - fan(1000)) / 3;
    EXPECT_NEAR(doubleArea(arc), limit, 1e-8 * std::max(1.0, std::abs(limit)));
  }
}

TEST(LengthOf, IsThatOfADensePolyline) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const Arc arc = random.cubic();
    const auto sum = [&](int pieces) {
      const std::vector<Vec2> p = polyline(arc, pieces);
      double total = 0;
      for (std::size_t k = 0; k + 1 < p.size(); ++k) total += distance(p[k], p[k + 1]);
      return total;
    };
    EXPECT_NEAR(lengthOf(arc, 1e-8), (4 * sum(4000) - sum(2000)) / 3, 1e-4);
  }
  EXPECT_EQ(lengthOf(Arc::line({0, 0}, {3, 4}), 1e-6), 5);
}

TEST(FlatteningParameters, KeepChordsWithinTheError) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const Arc arc = random.cubic();
    const double error = std::pow(10.0, random.in(-4, 0));
    const std::vector<double> t = flatteningParameters(arc, error);
    EXPECT_EQ(t.front(), 0);
    EXPECT_EQ(t.back(), 1);
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
      EXPECT_LT(t[k], t[k + 1]);
      const Arc chord = Arc::line(pointAt(arc, t[k]), pointAt(arc, t[k + 1]));
      for (const double s : {0.25, 0.5, 0.75}) {
        EXPECT_LE(nearestOn(chord, pointAt(arc, t[k] + (t[k + 1] - t[k]) * s)).distance,
                  error * (1 + 1e-9));
      }
    }
  }
  EXPECT_EQ(flatteningParameters(Arc::line({0, 0}, {1, 1}), 0.1), (std::vector<double>{0, 1}));
}

TEST(FlatteningParameters, AreTheSameForMovedAndMirroredArcs) {
  Random random(10);
  for (int i = 0; i < 500; ++i) {
    const Arc arc = random.cubic();
    const Vec2 u = test::polar(1, random.in(0, 1));
    const Vec2 by = random.point();
    const auto moved = [&](Vec2 p) { return Vec2{dot(p, u), cross(u, p)} + by; };
    const auto mirrored = [&](Vec2 p) { return Vec2{-p.x, p.y}; };
    const std::vector<double> t = flatteningParameters(arc, 0.001);
    for (const auto& map :
         {std::function<Vec2(Vec2)>(moved), std::function<Vec2(Vec2)>(mirrored)}) {
      const Arc image =
          Arc::cubic(map(arc.start), map(arc.control1), map(arc.control2), map(arc.end));
      EXPECT_EQ(flatteningParameters(image, 0.001), t);
      EXPECT_EQ(flatteningParameters(reversed(image), 0.001).size(), t.size());
    }
  }
}

TEST(NearestOn, IsNoFartherThanAnySample) {
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    const Arc arc = i % 5 == 0 ? random.line() : random.cubic();
    const Vec2 p = random.point();
    const Nearest nearest = nearestOn(arc, p);
    EXPECT_NEAR(distance(p, pointAt(arc, nearest.t)), nearest.distance, 1e-12);
    double best = 1e300;
    for (const Vec2 q : polyline(arc, 2000)) best = std::min(best, distance(p, q));
    EXPECT_LE(nearest.distance, best + 1e-12);
    EXPECT_GE(nearest.distance, best - 0.01);
  }
}

TEST(NearestOn, FindsPointsOfTheArcItself) {
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    const Arc arc = random.cubic();
    EXPECT_LT(nearestOn(arc, pointAt(arc, random.in(0, 1))).distance, 1e-11);
  }
}

}  // namespace
}  // namespace kiri
