// The convex hull holds all points and turns left at every corner.
// SPDX-License-Identifier: MIT
#include "core/geometry/hull.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/geometry/orientation.h"

namespace kiri {
namespace {

RC_GTEST_PROP(ConvexHull, HoldsEveryPointAndTurnsLeftAtEveryCorner, ()) {
  const auto numbers = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-9, 10), rc::gen::inRange(-9, 10)));
  std::vector<Vec2> points;
  for (const auto& [x, y] : numbers) points.push_back(Vec2{x / 3.0, y / 7.0});
  const std::vector<Vec2> hull = convexHull(points);
  if (hull.size() < 3) return;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 next = hull[(i + 1) % hull.size()];
    RC_ASSERT(orientation(hull[i], next, hull[(i + 2) % hull.size()]) > 0);
    for (const Vec2 p : points) RC_ASSERT(orientation(hull[i], next, p) >= 0);
  }
}

TEST(ConvexHull, LeavesOutWhatLiesOnASide) {
  EXPECT_EQ(convexHull({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {0, 2}, {2, 2}, {0, 1}}),
            (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

}  // namespace
}  // namespace kiri
