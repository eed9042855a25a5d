// SPDX-License-Identifier: MIT
#include "core/geometry/arc_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace kiri {
namespace {

TEST(RangeAlong, HoldsEverySampleAndIsReachedByOne) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-10, 10);
  for (int round = 0; round < 500; ++round) {
    double v[10];
    for (double& x : v) x = number(random);
    const Arc arc = Arc::cubic({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]});
    const Vec2 direction{v[8], v[9]};
    const Range range = rangeAlong(arc, direction);
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (int i = 0; i <= 2000; ++i) {
      const double value = dot(direction, pointAt(arc, i / 2000.0));
      low = std::min(low, value);
      high = std::max(high, value);
    }
    EXPECT_LE(range.low, low + 1e-9) << "round " << round;
    EXPECT_GE(range.high, high - 1e-9) << "round " << round;
    EXPECT_NEAR(range.low, low, 1e-3) << "round " << round;
    EXPECT_NEAR(range.high, high, 1e-3) << "round " << round;
  }
}

TEST(RangeAlong, OfAStraightArcIsThatOfItsEnds) {
  const Range range = rangeAlong(Arc::line({1, 2}, {4, -2}), {0, 1});
  EXPECT_EQ(range.low, -2);
  EXPECT_EQ(range.high, 2);
}

}  // namespace
}  // namespace kiri
