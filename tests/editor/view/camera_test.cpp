// Trackball, pan and zoom.
// SPDX-License-Identifier: MIT
#include "editor/view/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/rigid.h"
#include "tests/support/random_steps.h"

namespace kiri::testing {
namespace {

const Sphere kBall{{40, -30, 12}, 80};

Camera cameraOf(double fieldOfView, Vec2 size = {900, 700}) {
  Camera camera;
  camera.resize(size);
  camera.look(Camera::Preset::Angled, kBall);
  camera.setPerspective(fieldOfView);
  return camera;
}

Vec3 randomPlace(test::Random& random) {
  Vec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  while (dot(p, p) > 1) p = p * 0.7;
  return kBall.centre + p * kBall.radius;
}

/// How far apart, in pixels, two cameras show places of the ball.
double differenceOf(const Camera& a, const Camera& b) {
  test::Random random(99);
  double most = 0;
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = randomPlace(random);
    most = std::max(most, distance(a.map().toPixels(p), b.map().toPixels(p)));
  }
  return most;
}

void expectStraight(const Camera& camera) {
  const ViewFrame f = camera.map().frame;
  EXPECT_NEAR(length(f.right), 1, 1e-14);
  EXPECT_NEAR(length(f.up), 1, 1e-14);
  EXPECT_LE(distance(cross(f.right, f.up), f.toEye), 1e-14);
}

void expectEyeOutside(const Camera& camera) {
  const ViewFrame f = camera.map().frame;
  if (!f.isPerspective()) return;
  EXPECT_GT(distance(f.eye(), camera.ball().centre), camera.ball().radius);
  const Vec3 nearest = camera.ball().centre + f.toEye * camera.ball().radius;
  EXPECT_GT(f.enlargement(nearest), 0) << "all of the ball is before the eye";
}

/// The place of the ball's surface that is seen at a pixel, found by stepping along the line of
/// sight.
Vec3 onBall(const PaneMap& map, Vec2 pixels) {
  const Vec3 start = map.frame.onPlane(map.toView(pixels), kBall.centre, map.frame.toEye);
  const Vec3 ray =
      map.frame.isPerspective() ? normalized(map.frame.eye() - start) : map.frame.toEye;
  double low = -dot(start - kBall.centre, ray);
  double high = low + 2 * kBall.radius;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (distance(start + ray * middle, kBall.centre) < kBall.radius ? low : high) = middle;
  }
  return start + ray * low;
}

class Cameras : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(OrthographicAndPerspective, Cameras,
                         ::testing::Values(0.0, 20.0, 45.0, 90.0));

TEST_P(Cameras, FittedBallFillsThePaneAndNoMore) {
  Camera camera = cameraOf(GetParam());
  camera.fit(kBall);
  const PaneMap map = camera.map();
  test::Random random(3);
  double farthest = 0;
  for (int i = 0; i < 20000; ++i) {
    Vec3 d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (length(d) < 0.1) continue;
    const Vec2 p = map.toPixels(kBall.centre + normalized(d) * kBall.radius);
    farthest = std::max(farthest, distance(p, {450, 350}));
  }
  EXPECT_LT(farthest, 350);
  EXPECT_GT(farthest, 300);
  EXPECT_LE(distance(map.toPixels(kBall.centre), {450, 350}), 1e-9);
}

TEST_P(Cameras, ThePointOfTheBallUnderThePointerFollowsIt) {
  test::Random random(17);
  for (int i = 0; i < 200; ++i) {
    Camera camera = cameraOf(GetParam());
    camera.fit(kBall);
    camera.turn(random.between(-180, 180), random.between(-80, 80));
    const double reach = 0.6 * 350 / std::sqrt(2.0);  // what is a sphere in all the views
    const Vec2 from =
        Vec2{450, 350} + Vec2{random.between(-0.7, 0.7), random.between(-0.7, 0.7)} * reach;
    const Vec2 to =
        Vec2{450, 350} + Vec2{random.between(-0.7, 0.7), random.between(-0.7, 0.7)} * reach;
    const Vec3 grabbed = onBall(camera.map(), from);
    camera.orbit(from, to);
    EXPECT_LE(distance(camera.map().toPixels(grabbed), to), 1e-6);
    expectStraight(camera);
  }
}

TEST_P(Cameras, OrbitingThereAndBackReturns) {
  test::Random random(23);
  for (int i = 0; i < 200; ++i) {
    Camera camera = cameraOf(GetParam());
    camera.pan({random.between(-500, 500), random.between(-500, 500)});
    camera.zoom({random.between(0, 900), random.between(0, 700)}, random.between(0.1, 10));
    const Camera before = camera;
    const Vec2 a{random.between(0, 900), random.between(0, 700)};
    const Vec2 b{random.between(0, 900), random.between(0, 700)};
    camera.orbit(a, b);
    EXPECT_GT(differenceOf(before, camera), 1e-3);
    camera.orbit(b, a);
    EXPECT_LE(differenceOf(before, camera), 1e-8);
  }
}

TEST_P(Cameras, TenThousandMovesOfTheHandLeaveNoDrift) {
  test::Random random(29);
  Camera camera = cameraOf(GetParam());
  const Vec2 middle = camera.map().toPixels(kBall.centre);
  const double size = camera.map().pixelsPerMm;
  Vec2 at{450, 350};
  for (int i = 0; i < 10000; ++i) {
    const Vec2 next = at + Vec2{random.between(-30, 30), random.between(-30, 30)};
    camera.orbit(at, next);
    at = {std::clamp(next.x, 0.0, 900.0), std::clamp(next.y, 0.0, 700.0)};
  }
  expectStraight(camera);
  expectEyeOutside(camera);
  EXPECT_LE(distance(camera.map().toPixels(kBall.centre), middle), 1e-8);
  EXPECT_EQ(camera.map().pixelsPerMm, size);
}

TEST_P(Cameras, ADragFromTheCameraOfThePressReturnsByWhateverRoute) {
  const Camera atPress = cameraOf(GetParam());
  const Vec2 press{500, 300};
  Camera camera = atPress;
  for (const Vec2 now : {Vec2{600, 310}, Vec2{650, 500}, Vec2{300, 600}, Vec2{100, 100}, press}) {
    camera = atPress;
    camera.orbit(press, now);
  }
  EXPECT_EQ(differenceOf(camera, atPress), 0);
}

TEST_P(Cameras, OrbitingAboutAPlaceLeavesItWhereItIs) {
  test::Random random(31);
  for (int i = 0; i < 100; ++i) {
    Camera camera = cameraOf(GetParam());
    const Vec3 place = randomPlace(random);
    const Vec2 before = camera.map().toPixels(place);
    camera.orbit({random.between(0, 900), random.between(0, 700)},
                 {random.between(0, 900), random.between(0, 700)}, place);
    EXPECT_LE(distance(camera.map().toPixels(place), before), 1e-8);
    expectEyeOutside(camera);
  }
}

TEST_P(Cameras, ZoomKeepsWhatIsUnderThePointerAtEveryDepth) {
  test::Random random(37);
  for (int i = 0; i < 300; ++i) {
    Camera camera = cameraOf(GetParam());
    camera.turn(random.between(-180, 180), random.between(-180, 180));
    camera.pan({random.between(-200, 200), random.between(-200, 200)});
    const Vec3 place = randomPlace(random);
    const Vec2 before = camera.map().toPixels(place);
    camera.zoom(before, std::pow(10.0, random.between(-3, 3)));
    EXPECT_LE(distance(camera.map().toPixels(place), before), 1e-6);
  }
}

TEST_P(Cameras, ZoomEndsBeforeAnyoneIsLost) {
  Camera camera = cameraOf(GetParam());
  for (int i = 0; i < 500; ++i) camera.zoom({450, 350}, 1.3);
  const double largest = camera.map().pixelsPerMm;
  EXPECT_TRUE(std::isfinite(largest));
  for (int i = 0; i < 1000; ++i) camera.zoom({450, 350}, 1 / 1.3);
  const double smallest = camera.map().pixelsPerMm;
  EXPECT_GT(smallest * kBall.radius, 2) << "still to be seen";
  EXPECT_GT(largest / smallest, 1e4) << "and room for work on details";
  camera.zoom({450, 350}, 0);
  camera.zoom({450, 350}, -1);
  EXPECT_EQ(camera.map().pixelsPerMm, smallest) << "no factor, no zoom";
}

TEST_P(Cameras, PanMovesEverythingByTheSamePixels) {
  test::Random random(41);
  Camera camera = cameraOf(GetParam());
  for (int i = 0; i < 100; ++i) {
    const Vec3 place = randomPlace(random);
    const Vec2 before = camera.map().toPixels(place);
    const Vec2 by{random.between(-300, 300), random.between(-300, 300)};
    camera.pan(by);
    EXPECT_LE(distance(camera.map().toPixels(place), before + by), 1e-8);
  }
}

TEST_P(Cameras, AnotherBallDoesNotMakeThePictureJump) {
  test::Random random(43);
  for (int i = 0; i < 200; ++i) {
    Camera camera = cameraOf(GetParam());
    camera.turn(random.between(-180, 180), random.between(-80, 80));
    camera.pan({random.between(-200, 200), random.between(-200, 200)});
    const Camera before = camera;
    const Vec3 middle = kBall.centre + Vec3{random.between(-20, 20), random.between(-20, 20),
                                            random.between(-20, 20)};
    camera.setBall({middle, random.between(10, 60)});
    EXPECT_LE(differenceOf(before, camera), 1e-8);
    expectEyeOutside(camera);
    const Vec2 at = camera.map().toPixels(middle);
    camera.orbit({300, 300}, {500, 420});
    EXPECT_LE(distance(camera.map().toPixels(middle), at), 1e-8)
        << "it is what the eye turns about";
    expectEyeOutside(camera);
  }
}

TEST_P(Cameras, ABallThatWouldHoldTheEyePushesItBack) {
  Camera camera = cameraOf(GetParam());
  const Vec2 at = camera.map().toPixels(kBall.centre + Vec3{5, 6, 7});
  const double scale =
      camera.map().pixelsPerMm * camera.map().frame.enlargement(kBall.centre + Vec3{5, 6, 7});
  camera.setBall({kBall.centre + Vec3{5, 6, 7}, 3000});
  expectEyeOutside(camera);
  const PaneMap map = camera.map();
  EXPECT_LE(distance(map.toPixels(camera.ball().centre), at), 1e-6);
  EXPECT_NEAR(map.pixelsPerMm * map.frame.enlargement(camera.ball().centre), scale, 1e-9 * scale);
}

TEST_P(Cameras, TurningByKeysAddsUpAndUndoesItself) {
  Camera camera = cameraOf(GetParam());
  const Camera before = camera;
  for (int i = 0; i < 24; ++i) camera.turn(15, 0);
  EXPECT_LE(differenceOf(before, camera), 1e-8);
  camera.turn(0, 30);
  camera.turn(0, -30);
  camera.turn(0, 0, 45);
  camera.turn(0, 0, -45);
  EXPECT_LE(differenceOf(before, camera), 1e-8);
}

TEST_P(Cameras, InterpolatedCamerasGoEvenlyFromOneToTheOther) {
  test::Random random(47);
  for (int i = 0; i < 60; ++i) {
    Camera a = cameraOf(GetParam());
    a.turn(random.between(-180, 180), random.between(-80, 80));
    a.zoom({300, 300}, random.between(0.2, 4));
    Camera b = cameraOf(random.chance(0.5) ? 0 : 60);
    if (i % 3 == 0) b.look(Camera::Preset::Back, kBall);
    if (i % 5 == 0) b.setBall({kBall.centre + Vec3{9, 3, 4}, 50});
    EXPECT_EQ(differenceOf(Camera::interpolated(a, b, 0), a), 0);
    EXPECT_EQ(differenceOf(Camera::interpolated(a, b, 1), b), 0);
    EXPECT_LE(differenceOf(Camera::interpolated(a, b, 1e-9), a), 1e-3);
    EXPECT_LE(differenceOf(Camera::interpolated(a, b, 1 - 1e-9), b), 1e-3);
    Camera last = a;
    for (double t = 0.01; t < 1; t += 0.01) {
      const Camera now = Camera::interpolated(a, b, t);
      expectStraight(now);
      expectEyeOutside(now);
      EXPECT_LE(differenceOf(last, now), 120) << "no jump";
      last = now;
    }
  }
}

TEST(Camera, PresetsLookFromWhereTheySay) {
  Camera camera;
  camera.resize({900, 700});
  camera.look(Camera::Preset::Front, kBall);
  EXPECT_EQ(camera.map().frame.toEye, (Vec3{0, 0, 1}));
  EXPECT_EQ(camera.map().frame.up, (Vec3{0, 1, 0}));
  EXPECT_TRUE(camera.seesFront());
  camera.look(Camera::Preset::Back, kBall);
  EXPECT_EQ(camera.map().frame.toEye, (Vec3{0, 0, -1}));
  EXPECT_EQ(camera.map().frame.up, (Vec3{0, 1, 0}));
  EXPECT_FALSE(camera.seesFront());
  camera.look(Camera::Preset::Angled, kBall);
  EXPECT_TRUE(camera.seesFront());
  EXPECT_GT(camera.map().frame.up.z, 0.2);
}

TEST(Camera, DraggingToTheRightTurnsTheNearSideToTheRight) {
  Camera camera;
  camera.resize({900, 700});
  camera.look(Camera::Preset::Front, kBall);
  const Vec3 nearSide = kBall.centre + Vec3{0, 0, kBall.radius};
  Camera dragged = camera;
  dragged.orbit({450, 350}, {500, 350});
  EXPECT_GT(dragged.map().toPixels(nearSide).x, 499);
  Camera turned = camera;
  turned.turn(20, 0);
  EXPECT_GT(turned.map().toPixels(nearSide).x, 460);
  turned = camera;
  turned.turn(0, 20);
  EXPECT_LT(turned.map().toPixels(nearSide).y, 340);
  turned = camera;
  turned.turn(0, 0, 90);
  const Vec2 right = turned.map().toPixels(kBall.centre + Vec3{50, 0, 0});
  EXPECT_NEAR(right.x, 450, 1e-9);
  EXPECT_LT(right.y, 300) << "counter-clockwise";
}

TEST(Camera, AFittedPictureIsFittedAgainWhenThePaneChangesItsSize) {
  Camera camera;
  camera.look(Camera::Preset::Front, kBall);
  camera.resize({300, 300});
  Camera fresh;
  fresh.resize({300, 300});
  fresh.look(Camera::Preset::Front, kBall);
  EXPECT_EQ(differenceOf(camera, fresh), 0);
  camera.zoom({10, 10}, 1.5);
  const double scale = camera.map().pixelsPerMm;
  camera.resize({600, 300});
  EXPECT_EQ(camera.map().pixelsPerMm, scale) << "what the hand has set stays";
}

TEST(Camera, AModelWithoutSizeIsLookedAtAllTheSame) {
  Camera camera;
  camera.setPerspective(40);
  camera.look(Camera::Preset::Front, {{1, 2, 3}, 0});
  camera.orbit({10, 10}, {300, 200});
  camera.resize({0, 0});
  camera.zoom({0, 0}, 2);
  EXPECT_TRUE(std::isfinite(camera.map().toPixels(Vec3{1, 2, 3}).x));
  expectStraight(camera);
}

TEST(SheetCamera, FitsPansAndZoomsAboutThePointerFromBothSides) {
  for (const bool showsBack : {false, true}) {
    SheetCamera camera;
    camera.setShowsBack(showsBack);
    camera.fit({{10, 20}, {210, 120}});
    camera.resize({500, 400});
    for (const Vec3 corner : {Vec3{10, 20, 0}, Vec3{210, 120, 0}}) {
      const Vec2 p = camera.map().toPixels(corner);
      EXPECT_GT(p.x, 0);
      EXPECT_LT(p.x, 500);
      EXPECT_GT(p.y, 0);
      EXPECT_LT(p.y, 400);
    }
    EXPECT_NEAR(
        distance(camera.map().toPixels(Vec3{10, 20, 0}), camera.map().toPixels(Vec3{210, 20, 0})),
        460, 1e-9);
    const Vec3 place{33, 44, 0};
    const Vec2 before = camera.map().toPixels(place);
    camera.zoom(before, 3.7);
    EXPECT_LE(distance(camera.map().toPixels(place), before), 1e-9);
    camera.pan({13, -7});
    EXPECT_LE(distance(camera.map().toPixels(place), before + Vec2{13, -7}), 1e-9);
    const Vec2 middle = camera.map().toView({250, 200});
    camera.setShowsBack(!showsBack);
    EXPECT_NEAR(camera.map().toView({250, 200}).x, -middle.x, 1e-9)
        << "the same paper in the middle";
    for (int i = 0; i < 500; ++i) camera.zoom({0, 0}, 1.5);
    EXPECT_TRUE(std::isfinite(camera.map().pixelsPerMm));
    for (int i = 0; i < 500; ++i) camera.zoom({0, 0}, 0.6);
    EXPECT_GT(camera.map().pixelsPerMm, 0.01);
  }
}

}  // namespace
}  // namespace kiri::testing
