// Folds that would stretch the paper, and those that only look as if they would (thesis Figures 4.2
// and 4.3). SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

bool names(const Witness& witness, Vec2 a, Vec2 b) {
  for (const auto& [p, q] : witness.segments) {
    const bool isSame = distance(p, a) < 1e-6 && distance(q, b) < 1e-6;
    const bool isTurned = distance(p, b) < 1e-6 && distance(q, a) < 1e-6;
    if (isSame || isTurned) return true;
  }
  return false;
}

// A = (50, 0), B = (50, 100), Q = (100, 40), M = (50, 60).
TEST(Stretch, FoldingOneSideOfAHingeAcrossItIsRefusedWithTheHinge) {
  const Result<FoldedState> result = tryRun(
      "square 100; fold AB valley 50,0 50,100 left; unfold all; fold QM valley 100,40 50,60 to "
      "90,90 facets 75,50");
  ASSERT_TRUE(failsWith(result, ErrorCode::WouldStretch, "stretch"));
  EXPECT_TRUE(names(result.error().witness, {50, 60}, {50, 100}));
  EXPECT_NE(result.error().message.find("50"), std::string::npos) << "the place is missing";
}

TEST(Stretch, TheSameFoldIsLegalOnceTheHingeIsTorn) {
  const FoldedState state =
      run("square 100; fold AB valley 50,0 50,100 left; unfold all; tear 50,100 50,60;"
          "fold QM valley 100,40 50,60 to 90,90 facets 75,50");
  EXPECT_TRUE(isSound(state));
  EXPECT_TRUE(state.collisions.empty());
  EXPECT_TRUE(liesAt(state, {10, 90}, {10, 90, 0}));
}

TEST(Stretch, FoldingOneLayerOfTwoAcrossTheirSpineIsRefused) {
  const Result<FoldedState> result = tryRun(
      "square 100; fold A valley 50,0 50,100 left; fold B valley @model 0,50 110,50 left top 1");
  ASSERT_TRUE(failsWith(result, ErrorCode::WouldStretch, "stretch"));
  EXPECT_FALSE(result.error().witness.segments.empty());
}

// Fig 4.3: unfold AB, fold Q alone, refold AB.
TEST(Stretch, UnfoldingFirstLetsOneLayerFoldAlone) {
  const FoldedState state =
      run("square 100; fold AB valley 50,0 50,100 left; unfold AB; fold CD valley 70,0 100,30 to "
          "95,5; refold AB");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 3u);
  EXPECT_EQ(facetOf(state, {10, 10}), facetOf(state, {45, 95}));
  EXPECT_TRUE(isAbove(state, {20, 20}, {95, 5}));
}

TEST(Stretch, WhatIsWholeOnBothSidesOfTheSegmentDoesNotMove) {
  // The segment ends in the middle of the sheet: the paper holds together around its end.
  const Result<FoldedState> result = tryRun("square 100; fold A valley 0,50 50,50 left");
  EXPECT_FALSE(result.isOk() && facetCount(*result) == 1);
  if (result) {
    EXPECT_TRUE(isSound(*result));
  }
}

TEST(Stretch, AFoldAroundAHoleNeedsBothSidesOfIt) {
  // Only the left bridge beside the hole is creased; the right one holds the upper half.
  const Result<FoldedState> result = tryRun(
      "polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60; fold A valley -5,50 50,50 "
      "left");
  if (result) {
    EXPECT_TRUE(isSound(*result));
  } else {
    EXPECT_TRUE(failsWith(result, ErrorCode::WouldStretch, ""));
  }
}

}  // namespace
}  // namespace kiri::test
