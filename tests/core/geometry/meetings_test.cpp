// Meetings of arcs against dense polylines, and the hard cases: touches, common stretches, the same
// cut twice. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/cubic.h"
#include "tests/core/geometry/shapes.h"

namespace kiri {
namespace {

using test::polyline;
using test::Random;

const Tolerance kNear(141.4);

/// Every crossing of dense polylines: a lower bound that random arcs reach, as they hardly ever
/// graze.
std::vector<Meeting> crossingsOfPolylines(const Arc& a, const Arc& b) {
  const int n = 400;
  const std::vector<Vec2> p = polyline(a, n);
  const std::vector<Vec2> q = polyline(b, n);
  std::vector<Meeting> found;
  for (int i = 0; i < n; ++i) {
    const Vec2 a0 = p[static_cast<std::size_t>(i)];
    const Vec2 a1 = p[static_cast<std::size_t>(i) + 1];
    for (int j = 0; j < n; ++j) {
      const Vec2 b0 = q[static_cast<std::size_t>(j)];
      const Vec2 b1 = q[static_cast<std::size_t>(j) + 1];
      const double det = cross(a1 - a0, b1 - b0);
      if (det == 0) continue;
      const double s = cross(b0 - a0, b1 - b0) / det;
      const double r = cross(b0 - a0, a1 - a0) / det;
      if (s >= 0 && s < 1 && r >= 0 && r < 1) found.push_back({(i + s) / n, (j + r) / n});
    }
  }
  return found;
}

void expectSound(const std::vector<Meeting>& found, const Arc& a, const Arc& b) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LE(distance(pointAt(a, found[i].t), pointAt(b, found[i].u)), kNear.length());
    EXPECT_LE(found[i > 0 ? i - 1 : i].t, found[i].t);
  }
}

bool hasNear(const std::vector<Meeting>& found, Meeting m) {
  return std::any_of(found.begin(), found.end(), [&](const Meeting& f) {
    return std::abs(f.t - m.t) < 0.02 && std::abs(f.u - m.u) < 0.02;
  });
}

void expectLikePolylines(const Arc& a, const Arc& b, int number) {
  const std::vector<Meeting> found = meetings(a, b, kNear);
  const std::vector<Meeting> expected = crossingsOfPolylines(a, b);
  expectSound(found, a, b);
  for (const Meeting& m : expected)
    EXPECT_TRUE(hasNear(found, m)) << "pair " << number << " at " << m.t;
  // Polylines may miss a graze, but only in pairs.
  EXPECT_GE(found.size(), expected.size()) << "pair " << number;
  if (found.size() != expected.size()) {
    for (const Meeting& m : found) {
      EXPECT_LT(distance(pointAt(a, m.t), pointAt(b, m.u)), 1e-7);
    }
    EXPECT_EQ((found.size() - expected.size()) % 2, 0U) << "pair " << number;
  }
}

TEST(Meetings, OfRandomCubicsAreThoseOfTheirPolylines) {
  Random random(1);
  for (int i = 0; i < 300; ++i) expectLikePolylines(random.cubic(), random.cubic(), i);
}

TEST(Meetings, OfRandomLinesAndCubicsAreThoseOfTheirPolylines) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    expectLikePolylines(random.line(), random.cubic(), i);
    expectLikePolylines(random.cubic(), random.line(), i);
  }
}

TEST(Meetings, OfRandomLinesAreTheirCrossings) {
  Random random(3);
  for (int i = 0; i < 200; ++i) expectLikePolylines(random.line(), random.line(), i);
}

TEST(Meetings, AreTheSameWithTheArcsExchanged) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Arc a = i % 3 == 0 ? random.line() : random.cubic();
    const Arc b = random.cubic();
    const std::vector<Meeting> forth = meetings(a, b, kNear);
    std::vector<Meeting> back = meetings(b, a, kNear);
    for (Meeting& m : back) std::swap(m.t, m.u);
    std::sort(back.begin(), back.end(),
              [](const Meeting& m, const Meeting& n) { return m.t < n.t; });
    ASSERT_EQ(forth.size(), back.size()) << i;
    for (std::size_t k = 0; k < forth.size(); ++k) EXPECT_NEAR(forth[k].t, back[k].t, 1e-8);
  }
}

TEST(Meetings, OfALineThroughEndsAreExactlyTheEnds) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Arc curve = random.cubic();
    const double off = 0.5 * kNear.length();
    const Vec2 end = curve.end + test::polar(off, random.in(0, 1));
    const std::vector<Meeting> found = meetings(Arc::line(end, random.point()), curve, kNear);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].t, 0);
    EXPECT_EQ(found[0].u, 1);
  }
}

TEST(Meetings, OfAnEndOnAnArcHaveThatEnd) {
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    const Arc b = i % 2 == 0 ? random.cubic() : random.line();
    const double u = random.in(0.1, 0.9);
    const Vec2 p = pointAt(b, u);
    const Arc a = i % 3 == 0 ? Arc::line(random.point(), p)
                             : Arc::cubic(random.point(), random.point(), random.point(), p);
    const std::vector<Meeting> found = meetings(a, b, kNear);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.back().t, 1);
    EXPECT_LT(distance(pointAt(b, found.back().u), p), kNear.length());
    EXPECT_EQ(found.size() % 1, 0U);
    expectSound(found, a, b);
  }
}

TEST(Meetings, OfALineThatTouchesAreOne) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const Arc curve = random.cubic();
    const double u = random.in(0.1, 0.9);
    const Vec2 d = normalized(tangentAt(curve, u));
    const Vec2 p = pointAt(curve, u);
    const double shift = random.in(-0.9, 0.9) * kNear.length();
    const Arc line =
        Arc::line(p - d * 3 + perpendicular(d) * shift, p + d * 3 + perpendicular(d) * shift);
    const std::vector<Meeting> found = meetings(line, curve, kNear);
    const auto nearby = std::count_if(found.begin(), found.end(), [&](const Meeting& m) {
      return distance(pointAt(curve, m.u), p) < 0.05;
    });
    EXPECT_EQ(nearby, 1) << i;
    expectSound(found, line, curve);
  }
}

TEST(Meetings, OfCubicsThatTouchAreOne) {
  Random random(8);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const Arc a = random.cubic();
    const double t = random.in(0.2, 0.8);
    const Vec2 p = pointAt(a, t);
    const Vec2 d = normalized(tangentAt(a, t));
    // A parabola-like arc on the other side of the tangent than the one a bends to.
    const Vec2 ahead = pointAt(a, t + 0.01) - p;
    const double side = cross(d, ahead) > 0 ? -1 : 1;
    const Vec2 n = perpendicular(d) * side;
    // b(1/2) = p with tangent d: controls at height h, ends at height -3h... lifted so that the
    // middle is at p.
    const Arc b =
        Arc::cubic(p - d * 8 + n * 6, p - d * 3 - n * 2, p + d * 3 - n * 2, p + d * 8 + n * 6);
    const std::vector<Meeting> found = meetings(a, b, kNear);
    const auto nearby = std::count_if(found.begin(), found.end(), [&](const Meeting& m) {
      return distance(pointAt(a, m.t), p) < 0.02;
    });
    ++tried;
    EXPECT_EQ(nearby, 1) << i;
    expectSound(found, a, b);
  }
  EXPECT_EQ(tried, 300);
}

TEST(Meetings, OfACubicWithItselfAreItsEnds) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const Arc a = random.cubic();
    for (const bool isBackwards : {false, true}) {
      // The same cut seen through another layer: equal but for rounding.
      Arc b = isBackwards ? reversed(a) : a;
      b.control1 = b.control1 + Vec2{1e-13, -1e-13};
      const std::vector<Meeting> found = meetings(a, b, kNear);
      ASSERT_GE(found.size(), 2U) << i;
      EXPECT_TRUE(found.front().t == 0 && found.front().u == (isBackwards ? 1 : 0));
      EXPECT_TRUE(found.back().t == 1 && found.back().u == (isBackwards ? 0 : 1));
      EXPECT_EQ(found.size(), 2U) << i;
    }
  }
}

TEST(Meetings, OfOverlappingPartsAreTheEndsOfTheCommonStretch) {
  Random random(10);
  for (int i = 0; i < 200; ++i) {
    const Arc whole =
        Arc::cubic({0, 0}, {30, random.in(20, 60)}, {60, random.in(-60, 60)}, {100, 10});
    const Arc a = part(whole, 0, 0.7);
    const Arc b = i % 2 == 0 ? part(whole, 0.3, 1) : reversed(part(whole, 0.3, 1));
    const std::vector<Meeting> found = meetings(a, b, kNear);
    ASSERT_EQ(found.size(), 2U) << i;
    EXPECT_NEAR(found[0].t, 3.0 / 7, 1e-9);
    EXPECT_EQ(found[0].u, i % 2 == 0 ? 0 : 1);
    EXPECT_EQ(found[1].t, 1);
    EXPECT_NEAR(found[1].u, i % 2 == 0 ? 4.0 / 7 : 3.0 / 7, 1e-9);
  }
}

TEST(Meetings, OfOverlappingLinesAreTheEndsOfTheCommonStretch) {
  const std::vector<Meeting> found =
      meetings(Arc::line({0, 0}, {80, 60}), Arc::line({60, 45}, {-20, -15}), kNear);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].t, 0);
  EXPECT_NEAR(found[0].u, 0.75, 1e-15);
  EXPECT_NEAR(found[1].t, 0.75, 1e-15);
  EXPECT_EQ(found[1].u, 0);
}

TEST(Meetings, OfAStraightCubicAndALineAlongItAreTheEnds) {
  const Arc straight = Arc::cubic({0, 0}, {20, 10}, {50, 25}, {80, 40});
  const std::vector<Meeting> found = meetings(straight, Arc::line({40, 20}, {120, 60}), kNear);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].u, 0);
  EXPECT_EQ(found[1].t, 1);
  EXPECT_TRUE(lineMeetings(straight, {-2, -1}, {2, 1}, kNear).empty());
}

TEST(Meetings, OfNeighboursOnASmoothCurveAreTheirJoint) {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Arc whole = Arc::cubic({0, 0}, {random.in(20, 40), random.in(-60, 60)},
                                 {random.in(50, 80), random.in(-60, 60)}, {100, 10});
    const double t = random.in(0.1, 0.9);
    const std::vector<Meeting> found = meetings(part(whole, 0, t), part(whole, t, 1), kNear);
    ASSERT_EQ(found.size(), 1U) << i;
    EXPECT_EQ(found[0].t, 1);
    EXPECT_EQ(found[0].u, 0);
  }
}

TEST(Meetings, FindTheLoopOfACurveInItsHalves) {
  const Arc loop = Arc::cubic({0, 0}, {120, 80}, {-20, 80}, {100, 0});
  const std::vector<Meeting> found = meetings(part(loop, 0, 0.5), part(loop, 0.5, 1), kNear);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_LT(distance(pointAt(part(loop, 0, 0.5), found[0].t),
                     {50, pointAt(part(loop, 0, 0.5), found[0].t).y}),
            1e-9);
  EXPECT_EQ(found[1].t, 1);
  EXPECT_EQ(found[1].u, 0);
}

// The time limit of the test program would show if this took long.
TEST(Meetings, OfArcsSideBySideEndSoon) {
  Random random(12);
  for (const double gap : {1e-2, 1e-4, 1e-6, 3e-7, 1.5e-7, 1e-8}) {
    for (int i = 0; i < 20; ++i) {
      const Arc a = random.cubic();
      Arc b = a;
      for (Vec2* p : {&b.start, &b.control1, &b.control2, &b.end})
        *p = *p + test::polar(gap, random.in(0, 1));
      expectSound(meetings(a, b, kNear), a, b);
    }
  }
}

TEST(Meetings, OfArcsWithFoldedControlsAreFound) {
  // Controls on the ends: the speed there is zero.
  const Arc a = Arc::cubic({0, 0}, {0, 0}, {100, 100}, {100, 100});
  const Arc b = Arc::cubic({0, 100}, {0, 100}, {100, 0}, {100, 0});
  const std::vector<Meeting> found = meetings(a, b, kNear);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].t, 0.5, 1e-12);
  const std::vector<Meeting> corner =
      meetings(a, Arc::cubic({0, 0}, {0, 0}, {50, 0}, {100, 0}), kNear);
  ASSERT_EQ(corner.size(), 1U);
  EXPECT_EQ(corner[0].t, 0);
  EXPECT_EQ(corner[0].u, 0);
}

TEST(LineMeetings, AreRootsInOrder) {
  Random random(13);
  for (int i = 0; i < 2000; ++i) {
    const Arc arc = i % 4 == 0 ? random.line() : random.cubic();
    const Vec2 p = random.point();
    const Vec2 d = test::polar(random.in(0.1, 50), random.in(0, 1));
    const std::vector<double> found = lineMeetings(arc, p, d, kNear);
    for (const double t : found) {
      EXPECT_LT(std::abs(cross(d, pointAt(arc, t) - p)) / length(d), kNear.length());
    }
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    const auto side = [&](Vec2 q) { return cross(d, q - p) > 0; };
    EXPECT_EQ(found.size() % 2 == 1, side(arc.start) != side(arc.end));
  }
}

TEST(LineMeetings, OfMirroredArcsAreTheSameBits) {
  Random random(14);
  for (int i = 0; i < 500; ++i) {
    const Arc arc = random.cubic();
    const auto mirror = [](Vec2 p) { return Vec2{-p.x, p.y}; };
    const Arc image =
        Arc::cubic(mirror(arc.start), mirror(arc.control1), mirror(arc.control2), mirror(arc.end));
    const Vec2 p = random.point();
    const Vec2 d = test::polar(1, random.in(0, 1));
    EXPECT_EQ(lineMeetings(arc, p, d, kNear), lineMeetings(image, mirror(p), mirror(d), kNear));
  }
}

TEST(LineMeetings, HaveTouchesOnce) {
  const Arc arch = Arc::cubic({0, 0}, {0, 40}, {100, 40}, {100, 0});  // top at y = 30
  EXPECT_EQ(lineMeetings(arch, {0, 30}, {1, 0}, kNear), std::vector<double>{0.5});
  EXPECT_EQ(lineMeetings(arch, {0, 30 - 0.9 * kNear.length()}, {1, 0}, kNear).size(), 1U);
  EXPECT_EQ(lineMeetings(arch, {0, 30 + 0.9 * kNear.length()}, {1, 0}, kNear).size(), 1U);
  EXPECT_EQ(lineMeetings(arch, {0, 30 + 1.1 * kNear.length()}, {1, 0}, kNear).size(), 0U);
  EXPECT_EQ(lineMeetings(arch, {0, 0}, {1, 0}, kNear), (std::vector<double>{0, 1}));
  // An inflection whose tangent is the line.
  const Arc wave = Arc::cubic({-1, -1}, {-1.0 / 3, 1.0 / 3 * 3}, {1.0 / 3, -1}, {1, 1});
  EXPECT_FALSE(lineMeetings(wave, {0, 0}, {1, 0}, kNear).empty());
}

}  // namespace
}  // namespace kiri
