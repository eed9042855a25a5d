// Clipping of convex polygons against exact arithmetic.
// SPDX-License-Identifier: MIT
#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "core/geometry/convex.h"
#include "core/geometry/orientation.h"
#include "tests/core/geometry/shapes.h"

namespace kiri {
namespace {

using test::Random;
using test::randomConvex;

constexpr double kExactSize = 141.4;
constexpr double kExactEps = 1e-10 * kExactSize;

using Exact = CGAL::Gmpq;
struct ExactPoint {
  Exact x;
  Exact y;
};

/// Twice the signed area of the triangle a b c.
Exact turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<ExactPoint> exactly(const std::vector<Vec2>& points) {
  std::vector<ExactPoint> result;
  for (const Vec2 p : points) result.push_back({Exact(p.x), Exact(p.y)});
  return result;
}

/// Area of the intersection, by Sutherland and Hodgman with rational numbers: no tolerance, no
/// rounding.
double exactArea(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  std::vector<ExactPoint> common = exactly(a);
  const std::vector<ExactPoint> clip = exactly(b);
  for (std::size_t i = 0; i < clip.size(); ++i) {
    const ExactPoint& from = clip[i];
    const ExactPoint& to = clip[(i + 1) % clip.size()];
    std::vector<ExactPoint> kept;
    for (std::size_t k = 0; k < common.size(); ++k) {
      const ExactPoint& p = common[k];
      const ExactPoint& q = common[(k + 1) % common.size()];
      const Exact dp = turn(from, to, p);
      const Exact dq = turn(from, to, q);
      if (dp >= 0) kept.push_back(p);
      if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
        const Exact s = dp / (dp - dq);
        kept.push_back({p.x + (q.x - p.x) * s, p.y + (q.y - p.y) * s});
      }
    }
    common = kept;
  }
  Exact sum = 0;
  for (std::size_t k = 1; k + 1 < common.size(); ++k)
    sum += turn(common[0], common[k], common[k + 1]);
  return CGAL::to_double(sum) / 2;
}

bool isNearlyConvex(const std::vector<Vec2>& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 a = p[(i + 1) % p.size()] - p[i];
    const Vec2 b = p[(i + 2) % p.size()] - p[(i + 1) % p.size()];
    if (cross(a, b) < -kExactEps * (length(a) + length(b))) return false;
  }
  return true;
}

TEST(Intersection, HasTheAreaThatExactArithmeticFinds) {
  Random random(1);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Vec2> a = randomConvex(random, random.count(3, 9));
    const std::vector<Vec2> b = randomConvex(random, random.count(3, 9));
    const std::vector<Vec2> common = intersection(a, b, kExactEps);
    const double exact = exactArea(a, b);
    EXPECT_NEAR(common.empty() ? 0 : signedArea(common), exact, 300 * kExactEps) << i;
    EXPECT_TRUE(isNearlyConvex(common)) << i;
    if (!common.empty()) ++met;
  }
  EXPECT_GT(met, 50);
}

TEST(Orientation, IsThatOfExactArithmetic) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const Vec2 a = random.point();
    const Vec2 b = random.point();
    const Vec2 c = i % 2 == 0 ? lerp(a, b, random.in(-1, 2)) : random.point();
    const std::vector<ExactPoint> p = exactly({a, b, c});
    EXPECT_EQ(orientation(a, b, c), static_cast<int>(CGAL::sign(turn(p[0], p[1], p[2]))));
  }
}

}  // namespace
}  // namespace kiri
