// Rotations: exact where they can be, within an ulp or two elsewhere, a group everywhere.
// SPDX-License-Identifier: MIT
#include "core/geometry/rigid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace kiri {
namespace {

constexpr double kRounding = 2e-15;

/// Largest difference of two motions, entry by entry.
double difference(const Rigid& a, const Rigid& b) {
  return std::max(
      {distance(a.x, b.x), distance(a.y, b.y), distance(a.z, b.z), distance(a.origin, b.origin)});
}

class RandomMotion {
 public:
  explicit RandomMotion(unsigned seed) : engine_(seed) {}
  double in(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(engine_);
  }
  Vec3 point() { return {in(-100, 100), in(-100, 100), in(-100, 100)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v{in(-1, 1), in(-1, 1), in(-1, 1)};
      if (length(v) > 0.1) return normalized(v);
    }
  }

 private:
  std::mt19937 engine_;
};

TEST(CosSinDegrees, AgreesWithTheLibrary) {
  RandomMotion random(1);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const double degrees = random.in(-720, 720);
    const CosSin turn = cosSinDegrees(degrees);
    const long double radians =
        static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180;
    worst = std::max(worst, static_cast<double>(
                                std::abs(std::cos(radians) - static_cast<long double>(turn.cos))));
    worst = std::max(worst, static_cast<double>(
                                std::abs(std::sin(radians) - static_cast<long double>(turn.sin))));
  }
  EXPECT_LT(worst, 1.3e-16);  // little more than half a unit in the last place
}

TEST(CosSinDegrees, IsRelativelyExactForSmallAngles) {
  RandomMotion random(2);
  for (int i = 0; i < 20000; ++i) {
    const double degrees = std::pow(10.0, random.in(-12, 1));
    const double expected = static_cast<double>(
        std::sin(static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180));
    EXPECT_NEAR(cosSinDegrees(degrees).sin / expected, 1, 2.5e-16) << degrees;
  }
}

TEST(CosSinDegrees, IsExactAtMultiplesOf90) {
  const double cosines[] = {1, 0, -1, 0};
  for (int i = -40; i <= 40; ++i) {
    const CosSin turn = cosSinDegrees(90.0 * i);
    EXPECT_EQ(turn.cos, cosines[((i % 4) + 4) % 4]) << i;
    EXPECT_EQ(turn.sin, cosines[(((i - 1) % 4) + 4) % 4]) << i;
    EXPECT_FALSE(std::signbit(turn.cos) && turn.cos == 0);
    EXPECT_FALSE(std::signbit(turn.sin) && turn.sin == 0);
  }
}

TEST(CosSinDegrees, IsExactlySymmetric) {
  RandomMotion random(3);
  for (int i = 0; i < 20000; ++i) {
    // Steps of 2^-20 degrees, so that 90 - a and the like are exact.
    const double a = std::floor(random.in(0, 90) * 1048576) / 1048576;
    const CosSin turn = cosSinDegrees(a);
    EXPECT_EQ(cosSinDegrees(-a).sin, -turn.sin);
    EXPECT_EQ(cosSinDegrees(-a).cos, turn.cos);
    EXPECT_EQ(cosSinDegrees(90 - a).sin, turn.cos);
    EXPECT_EQ(cosSinDegrees(180 - a).cos, -turn.cos);
    EXPECT_EQ(cosSinDegrees(a + 180).sin, -turn.sin);
    EXPECT_EQ(cosSinDegrees(a + 3600).sin, turn.sin);
  }
  EXPECT_EQ(cosSinDegrees(45).cos, cosSinDegrees(45).sin);
  EXPECT_EQ(cosSinDegrees(30).sin, 0.5);
  EXPECT_EQ(cosSinDegrees(60).cos, 0.5);
}

TEST(AngleDegrees, IsTheInverseOfCosSin) {
  RandomMotion random(4);
  for (int i = 0; i < 100000; ++i) {
    const double degrees = random.in(-180, 180);
    const CosSin turn = cosSinDegrees(degrees);
    const double scale = std::pow(10.0, random.in(-8, 8));
    EXPECT_NEAR(angleDegrees(turn.cos * scale, turn.sin * scale), degrees, 6e-14);
    EXPECT_NEAR(angleDegrees(turn.cos, turn.sin),
                std::atan2(turn.sin, turn.cos) * 180 / std::numbers::pi, 6e-14);
  }
}

TEST(AngleDegrees, IsExactOnAxesAndDiagonals) {
  for (const double s : {1.0, 1e-300, 3.7, 1e200}) {
    EXPECT_EQ(angleDegrees(s, 0.0), 0);
    EXPECT_EQ(angleDegrees(s, s), 45);
    EXPECT_EQ(angleDegrees(0.0, s), 90);
    EXPECT_EQ(angleDegrees(-s, s), 135);
    EXPECT_EQ(angleDegrees(-s, 0.0), 180);
    EXPECT_EQ(angleDegrees(-s, -0.0), 180);
    EXPECT_EQ(angleDegrees(-s, -s), -135);
    EXPECT_EQ(angleDegrees(0.0, -s), -90);
    EXPECT_EQ(angleDegrees(s, -s), -45);
  }
  EXPECT_EQ(angleDegrees(-1, -1e-300), 180);
}

TEST(AngleDegrees, IsRelativelyExactForSmallAngles) {
  EXPECT_NEAR(angleDegrees(1, 1e-9) / (1e-9 * 180 / std::numbers::pi), 1, 1e-15);
}

TEST(RotationAbout, KeepsItsAxisAndAllLengths) {
  RandomMotion random(5);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 point = random.point();
    const Vec3 axis = random.direction();
    const Rigid r = rotationAbout(point, axis, random.in(-360, 360));
    EXPECT_LT(distance(r.apply(point + axis * 50), point + axis * 50), 1e-13);
    EXPECT_NEAR(dot(r.x, r.y), 0, kRounding);
    EXPECT_NEAR(dot(r.x, r.x), 1, kRounding);
    EXPECT_NEAR(dot(cross(r.x, r.y), r.z), 1, kRounding);
  }
}

TEST(RotationAbout, AddsAnglesAboutOneAxis) {
  RandomMotion random(6);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 point = random.point();
    const Vec3 axis = random.direction();
    const double a = random.in(-180, 180);
    const double b = random.in(-180, 180);
    const Rigid both = compose(rotationAbout(point, axis, a), rotationAbout(point, axis, b));
    EXPECT_LT(difference(both, rotationAbout(point, axis, a + b)), 3e-13);
    EXPECT_LT(
        difference(compose(rotationAbout(point, axis, a), rotationAbout(point, axis, -a)), {}),
        3e-13);
  }
}

TEST(RotationAbout, TurnsCounterClockwiseSeenAgainstTheAxis) {
  const Rigid r = rotationAbout({1, 1, 0}, {0, 0, 1}, 90);
  EXPECT_EQ(r.apply(Vec2{2, 1}), (Vec3{1, 2, 0}));
}

TEST(RotationAbout, IsTheIdentityForWholeTurns) {
  EXPECT_EQ(rotationAbout({3, 4, 5}, {0.6, 0.8, 0}, 0), Rigid{});
  EXPECT_EQ(rotationAbout({3, 4, 5}, {0.6, 0.8, 0}, 360), Rigid{});
  EXPECT_EQ(rotationAbout({3, 4, 5}, {0.6, 0.8, 0}, -720), Rigid{});
}

TEST(RotationAbout, ReflectsInTheLineAt180) {
  const Rigid r = rotationAbout({75, 0, 0}, {0, 1, 0}, 180);
  EXPECT_EQ(r.apply(Vec2{10, 20}), (Vec3{140, 20, 0}));
  EXPECT_EQ(r.z, (Vec3{0, 0, -1}));
  EXPECT_EQ(rotationAbout({75, 0, 0}, {0, 1, 0}, -180), r);
}

TEST(RotationAbout, KeepsFlatPosesExactlyFlat) {
  RandomMotion random(7);
  Rigid pose;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 d = normalized(Vec2{random.in(-1, 1), random.in(-1, 1)});
    const Vec3 point{random.in(-100, 100), random.in(-100, 100), 0};
    pose = compose(rotationAbout(point, {d.x, d.y, 0}, i % 2 == 0 ? 180 : -180), pose);
    EXPECT_EQ(pose.z, (Vec3{0, 0, i % 2 == 0 ? -1.0 : 1.0}));
    EXPECT_EQ(pose.x.z, 0);
    EXPECT_EQ(pose.y.z, 0);
    EXPECT_EQ(pose.origin.z, 0);
    EXPECT_FALSE(std::signbit(pose.origin.z));
  }
  EXPECT_NEAR(dot(pose.x, pose.x), 1, 2e-13);
}

TEST(Compose, DoesTheSecondFirst) {
  RandomMotion random(8);
  for (int i = 0; i < 1000; ++i) {
    const Rigid a = rotationAbout(random.point(), random.direction(), random.in(-180, 180));
    const Rigid b =
        compose(translation(random.point()), rotationAbout(random.point(), random.direction(), 77));
    const Vec3 p = random.point();
    EXPECT_LT(distance(compose(a, b).apply(p), a.apply(b.apply(p))), 1e-12);
    const Vec2 q{random.in(-100, 100), random.in(-100, 100)};
    EXPECT_LT(distance(b.pullBack(b.apply(q)), q), 1e-12);
  }
}

}  // namespace
}  // namespace kiri
