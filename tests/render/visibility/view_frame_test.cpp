// Views from any side: where things appear when the eye goes round the model.
// SPDX-License-Identifier: MIT
#include "render/visibility/view_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kiri::testing {
namespace {

void expectNear(Vec3 a, Vec3 b, double slack) { EXPECT_LE(distance(a, b), slack); }

TEST(ViewFrom, NamedViewsArePlacesOfTheEye) {
  const auto equal = [](const ViewFrame& a, const ViewFrame& b) {
    return a.right == b.right && a.up == b.up && a.toEye == b.toEye;
  };
  EXPECT_TRUE(equal(viewFrom(0, 90), frontView()));
  EXPECT_TRUE(equal(viewFrom(180, -90), backView()));
}

TEST(ViewFrom, AxesAreARightHandedFrameFromEverySide) {
  for (double azimuth = -360; azimuth <= 360; azimuth += 17) {
    for (double elevation = -90; elevation <= 90; elevation += 7.5) {
      const ViewFrame view = viewFrom(azimuth, elevation);
      expectNear(cross(view.right, view.up), view.toEye, 1e-15);
      EXPECT_NEAR(length(view.right), 1, 1e-15);
      EXPECT_NEAR(length(view.up), 1, 1e-15);
      EXPECT_NEAR(dot(view.right, view.up), 0, 1e-15);
      EXPECT_GE(view.up.z, 0) << "z never points down on the picture";
      EXPECT_NEAR(view.toEye.z, std::sin(elevation * M_PI / 180), 1e-14);
    }
  }
}

TEST(ViewFrom, NearEdgeOfTheSheetIsBelowAndNearFromTheSouth) {
  const ViewFrame view = viewFrom(0, 30);
  const Vec3 nearEdge{0, -1, 0}, farEdge{0, 1, 0}, east{1, 0, 0};
  EXPECT_GT(view.depth(nearEdge), view.depth(farEdge));
  EXPECT_LT(view.project(nearEdge).y, view.project(farEdge).y);
  EXPECT_EQ(view.project(east).x, 1);
}

TEST(ViewFrom, EyeGoesRoundBySouthEastNorth) {
  EXPECT_EQ(viewFrom(0, 0).toEye, (Vec3{0, -1, 0}));
  EXPECT_EQ(viewFrom(90, 0).toEye, (Vec3{1, 0, 0}));
  EXPECT_EQ(viewFrom(180, 0).toEye, (Vec3{0, 1, 0}));
  EXPECT_EQ(viewFrom(-90, 0).toEye, (Vec3{-1, 0, 0}));
}

TEST(ViewFrom, NothingFlipsAtThePoles) {
  for (const double pole : {90.0, -90.0}) {
    for (const double azimuth : {0.0, 40.0, 200.0}) {
      const ViewFrame at = viewFrom(azimuth, pole);
      const ViewFrame close = viewFrom(azimuth, pole * (1 - 1e-6));
      expectNear(at.right, close.right, 1e-5);
      expectNear(at.up, close.up, 1e-5);
    }
  }
}

}  // namespace
}  // namespace kiri::testing
