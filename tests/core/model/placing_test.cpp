// Turning over, turning round and moving: rigid motions of the whole model.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

TEST(Rotate, TurnsCounterClockwiseAboutTheMiddleOfTheBox) {
  const FoldedState state = run("rectangle 80 40; rotate 90");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {0, 0}, {60, -20, 0}));
  EXPECT_TRUE(liesAt(state, {80, 0}, {60, 60, 0}));
}

TEST(Rotate, TurnsAboutAPoint) {
  const FoldedState state = run("rectangle 80 40; rotate 180 0,0");
  EXPECT_TRUE(liesAt(state, {80, 40}, {-80, -40, 0}));
}

TEST(Rotate, FourQuartersAreNothingAtAll) {
  const FoldedState state = run("square 100; fold A valley 20,0 100,70 left");
  EXPECT_TRUE(isClean(state));
  const FoldedState turned =
      after(state, "rotate 90 0,0; rotate 90 0,0; rotate 90 0,0; rotate 90 0,0");
  EXPECT_TRUE(isSameState(state, turned));
}

TEST(Move, ShiftsEveryFacet) {
  const FoldedState state = run("square 100; fold A valley 90 50,0 50,100 left; move 5,-7");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {0, 50}, {55, 43, 50}));
}

TEST(Placing, ChangesNoAngleNoAreaNoLayer) {
  const FoldedState state = run(
      "square 100; fold A valley 50,0 50,100 left; fold B mountain 120 @model 40,50 110,50 left");
  for (const char* text : {"turn", "turn horizontal", "rotate 33", "move 3,4"}) {
    const FoldedState placed = after(state, text);
    EXPECT_TRUE(isSound(placed)) << text;
    EXPECT_NEAR(areaOf(placed), areaOf(state), 1e-9);
    EXPECT_EQ(anglesOf(placed, "B"), anglesOf(state, "B")) << text;
  }
}

TEST(Placing, MovesAllPiecesAlike) {
  const FoldedState state = run("square 100; cut 50,-10 50,110; turn");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {0, 0}, {100, 0, 0}));
  EXPECT_TRUE(liesAt(state, {100, 0}, {0, 0, 0}));
}

}  // namespace
}  // namespace kiri::test
