// What paper meets on its way, with answers known beforehand.
// SPDX-License-Identifier: MIT
#include "core/sweep/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/expect.h"
#include "tests/support/line_motion.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

SweepReport sweepTo(const FoldedState& state, const std::string& line, double amount) {
  const LineMotion how = motionTo(state, line, amount);
  return sweep(state, how.moves, how.motion);
}

constexpr double kDegree = 180 / std::numbers::pi;

TEST(Sweep, AFlapThatMeetsAPostCollides) {
  // The flap is 50 long and its hinge 30 from the post: its end meets the post where it is 40 high.
  const FoldedState state =
      run("rectangle 130 20; fold P valley 90 80,0 80,20 right; fold F valley 1 50,0 50,20 left");
  const SweepReport report = sweepTo(state, "F", 180);
  ASSERT_EQ(report.verdict, SweepVerdict::Collides);
  const double turned = 180 - std::acos(30.0 / 50) * kDegree - 1;
  EXPECT_NEAR(std::abs(report.degrees), turned, 1e-4);
  EXPECT_NEAR(report.place.x, 80, 1e-4);
  EXPECT_NEAR(report.place.z, 40, 1e-4);
  EXPECT_EQ(report.moving, facetOf(state, {10, 10}));
  EXPECT_EQ(report.resting, facetOf(state, {120, 10}));
}

TEST(Sweep, AFlapThatIsTooShortForThePostIsFree) {
  const FoldedState state =
      run("rectangle 130 20; fold P valley 90 80,0 80,20 right; fold F valley 1 29,0 29,20 left");
  EXPECT_EQ(sweepTo(state, "F", 180).verdict, SweepVerdict::Free);
}

TEST(Sweep, AFlapThatJustTouchesThePostIsFree) {
  // 40 long, 40 away: it only touches the foot of the post as it lands.
  const FoldedState state =
      run("rectangle 130 20; fold P valley 90 80,0 80,20 right; fold F valley 1 40,0 40,20 left");
  EXPECT_EQ(sweepTo(state, "F", 180).verdict, SweepVerdict::Free);
  EXPECT_EQ(sweepTo(state, "F", 179).verdict, SweepVerdict::Free);
}

// A strip folded in half; the upper layer's free end U stands, the lower layer's end L has the same
// hinge line and, under it, the same outline.
FoldedState twoPages(const std::string& upper) {
  return run(
      "rectangle 200 20; fold H valley 100,0 100,20 right;"
      "fold U valley " +
      upper +
      " @model 40,-5 40,25 left facets p:170,10;"
      "fold L valley 1 @model 40,-5 40,25 left facets p:20,10");
}

TEST(Sweep, APageTurnedThroughAPageOfTheSameOutlineCollides) {
  const FoldedState state = twoPages("90");
  EXPECT_EQ(sweepTo(state, "L", 80).verdict, SweepVerdict::Free);
  EXPECT_EQ(sweepTo(state, "L", 90).verdict, SweepVerdict::Free) << "it comes to lie on it";
  EXPECT_EQ(sweepTo(state, "L", -90).verdict, SweepVerdict::Free);
  const SweepReport report = sweepTo(state, "L", 120);
  ASSERT_EQ(report.verdict, SweepVerdict::Collides);
  EXPECT_NEAR(std::abs(report.degrees), 89, 1e-9);
  EXPECT_NEAR(report.place.x, 40, 1e-9);
  EXPECT_EQ(report.resting, facetOf(state, {190, 10}));
}

TEST(Sweep, TurningOneFlatPacketMeetsNothing) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left;"
          "fold C valley @model 75,-10 75,110 right");
  for (const double amount : {0.0, 30.0, 90.0, 179.0, -20.0}) {
    EXPECT_EQ(sweepTo(state, "C", amount).verdict, SweepVerdict::Free) << amount;
  }
}

TEST(Sweep, WallsOfATrayOnlyTouchAtTheirEdges) {
  // A tray: four walls, the corners torn off. Each wall slides along the plane of its neighbours.
  const char* tray =
      "polygon 20,0 80,0 80,20 100,20 100,80 80,80 80,100 20,100 20,80 0,80 0,20 20,20;"
      "fold E valley 90 80,20 80,80 right; fold N valley 1 80,80 20,80 right;"
      "fold W valley 90 20,80 20,20 right;";
  const FoldedState state = run(tray);
  for (const double amount : {90.0, 120.0, 179.0, 0.0, -90.0}) {
    EXPECT_EQ(sweepTo(state, "N", amount).verdict, SweepVerdict::Free) << amount;
  }
}

TEST(Sweep, AWallThatLeansInCollidesWithItsNeighbour) {
  const FoldedState state =
      run("polygon 20,0 80,0 80,20 100,20 100,80 80,80 80,100 20,100 20,80 0,80 0,20 20,20;"
          "fold E valley 120 80,20 80,80 right; fold N valley 1 80,80 20,80 right");
  const SweepReport report = sweepTo(state, "N", 150);
  ASSERT_EQ(report.verdict, SweepVerdict::Collides);
  // Both lean in by 30 degrees when the corners meet: the wall reaches as far in as up.
  EXPECT_NEAR(std::abs(report.degrees) + 1, 90, 1);
}

TEST(Sweep, ArmsOfACrossStandUpBesideEachOther) {
  const FoldedState state =
      run("polygon 20,0 40,0 40,20 60,20 60,40 40,40 40,60 20,60 20,40 0,40 0,20 20,20;"
          "fold E valley 90 40,20 40,40 right; fold N valley 1 40,40 20,40 right");
  EXPECT_EQ(sweepTo(state, "N", 120).verdict, SweepVerdict::Free);
  EXPECT_EQ(sweepTo(state, "N", 179).verdict, SweepVerdict::Free);
}

// A wall on the line x = 50 with an upright crease B at y = 50. Beyond B the paper on the ground is
// torn from the rest of it and turns with the wall, within the plane of the ground.
FoldedState wallWithFoot() {
  return run(
      "square 100; edge 0,50 50,50; tear 0,50 50,50; fold B valley 0 50,50 100,50 left;"
      "fold A valley 90 50,0 50,100 right");
}

TEST(Sweep, PaperThatSlidesOverOtherPaperOfItsPlaneIsUndecided) {
  const SweepReport report = sweepTo(wallWithFoot(), "B", 60);
  EXPECT_EQ(report.verdict, SweepVerdict::Undecided);
}

TEST(Sweep, PaperThatSlidesAwayWithinItsPlaneIsFree) {
  EXPECT_EQ(sweepTo(wallWithFoot(), "B", -60).verdict, SweepVerdict::Free);
}

}  // namespace
}  // namespace kiri::test
