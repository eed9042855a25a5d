// Folding: what is split, what moves, where it lands.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

TEST(Fold, TurnsTheLeftSideOverTheLineOnTopInAValley) {
  const FoldedState state = run("square 100; fold A valley 0,0 100,100 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
  EXPECT_TRUE(liesAt(state, {0, 100}, {100, 0, 0}));
  EXPECT_TRUE(liesAt(state, {100, 0}, {100, 0, 0}));
  EXPECT_TRUE(isAbove(state, {20, 80}, {80, 20}));
  EXPECT_EQ(anglesOf(state, "A"), (std::vector<double>{180}));
}

TEST(Fold, TurnsTheMovingSideBeneathInAMountain) {
  const FoldedState state = run("square 100; fold A mountain 0,0 100,100 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {0, 100}, {100, 0, 0}));
  EXPECT_TRUE(isAbove(state, {80, 20}, {20, 80}));
  EXPECT_EQ(anglesOf(state, "A"), (std::vector<double>{-180}));
}

TEST(Fold, MovesTheRightSideWhenToldSo) {
  const FoldedState state = run("square 100; fold A valley 50,0 50,100 right");
  EXPECT_TRUE(liesAt(state, {100, 50}, {0, 50, 0}));
  EXPECT_TRUE(liesAt(state, {0, 50}, {0, 50, 0}));
}

TEST(Fold, MovesTheSideOfAPoint) {
  const FoldedState state = run("square 100; fold A valley 50,0 50,100 to 90,50");
  EXPECT_TRUE(liesAt(state, {100, 50}, {0, 50, 0}));
}

TEST(Fold, MovesTheSideOfChosenFacets) {
  const FoldedState state =
      run("square 100; edge 30,0 30,100; fold A valley 0,50 100,50 moving 10,90 60,90");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {10, 100}, {10, 0, 0}));
  EXPECT_TRUE(liesAt(state, {60, 100}, {60, 0, 0}));
}

TEST(Fold, ThroughTwoLayersMakesAMountainAndAValley) {
  const FoldedState state =
      run("square 100; fold A valley 0,0 100,100 left; fold B valley @model 50,50 100,0 right");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 4u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Hinge), 4u);
  EXPECT_EQ(anglesOf(state, "B"), (std::vector<double>{-180, 180}));
  EXPECT_NEAR(areaOf(state), 10000, 1e-8);
}

TEST(Fold, TakesAlongWhatIsRolledUpOnTheLine) {
  const std::string rolled =
      "square 100; fold A valley 75,0 75,100 right; fold B valley @model 50,0 50,100 right; "
      "fold C valley @model 25,0 25,100 right";
  const FoldedState state = run(rolled);
  EXPECT_TRUE(isClean(state));
  for (const char* name : {"A", "B", "C"}) {
    EXPECT_EQ(anglesOf(state, name), (std::vector<double>{180})) << name;
  }
  EXPECT_TRUE(liesAt(state, {100, 0}, {0, 0, 0}));
  EXPECT_TRUE(isAbove(state, {40, 50}, {90, 50}));
  EXPECT_TRUE(isAbove(state, {90, 50}, {60, 50}));
  EXPECT_TRUE(isAbove(state, {60, 50}, {10, 50}));
  const FoldedState open = run(rolled + "; unfold C");
  EXPECT_TRUE(isClean(open));
  EXPECT_EQ(anglesOf(open, "A"), (std::vector<double>{180}));
  EXPECT_TRUE(liesAt(open, {100, 0}, {50, 0, 0}));
}

TEST(Fold, TakesAlongTwoLayersThatAreRolledUpTogether) {
  // The crease of the half, at the end, lies on the line of the last fold, too.
  const FoldedState state =
      run("square 100; fold H valley 50,0 50,100 right; fold T valley @model 40,-5 40,105 right; "
          "fold A valley @model 30,-5 30,105 right; fold B valley @model 20,-5 20,105 right; "
          "fold C valley @model 10,-5 10,105 right");
  EXPECT_TRUE(isClean(state));
  for (const char* name : {"T", "A", "B", "C"}) {
    EXPECT_EQ(anglesOf(state, name), (std::vector<double>{-180, 180})) << name;
  }
  EXPECT_TRUE(liesAt(state, {50, 0}, {10, 0, 0}));
}

TEST(Fold, StopsAtAnAngle) {
  const FoldedState state = run("square 100; fold A valley 90 50,0 50,100 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_FALSE(isFlat(state));
  EXPECT_TRUE(liesAt(state, {0, 50}, {50, 50, 50}));
  const FoldedState mountain = run("square 100; fold A mountain 90 50,0 50,100 left");
  EXPECT_TRUE(liesAt(mountain, {0, 50}, {50, 50, -50}));
}

TEST(Fold, SeesValleyAsTheModelLiesNotAsThePaperDoes) {
  const FoldedState state = run("square 100; turn; fold A valley @model 50,0 50,100 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(anglesOf(state, "A"), (std::vector<double>{-180}));
  EXPECT_TRUE(isAbove(state, {80, 50},
                      {20, 50}));  // the paper's right lay at the left and was turned on top
}

TEST(Fold, ThroughTheTopLayerLeavesTheOtherWhole) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley @model 110,70 70,110 to "
          "m:98,98 top 1");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 3u);
  EXPECT_TRUE(liesAt(state, {0, 100}, {80, 80, 0}));
  EXPECT_TRUE(liesAt(state, {100, 100}, {100, 100, 0}));
}

TEST(Fold, ThroughTheTopTwoOfFourLayers) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left;"
          "fold C valley @model 110,30 70,-10 to m:98,2 top 2");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 6u);
}

TEST(Fold, OfTheLowerLayerAloneGoesBeneath) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B mountain @model 110,70 70,110 to "
          "m:98,98 facets p:75,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {100, 100}, {80, 80, 0}));
  EXPECT_TRUE(isAbove(state, {75, 70}, {98, 98}));
}

TEST(Fold, DoesNotSplitFacetsThatTheSegmentDoesNotCross) {
  const FoldedState state =
      run("square 100; edge 50,0 50,100; fold A valley 55,110 110,55 to 98,98");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 3u);
}

TEST(Fold, OfOneArmLeavesTheOtherArm) {
  const FoldedState state = run(
      "polygon 0,0 100,0 100,100 70,100 70,30 30,30 30,100 0,100; fold A valley -5,60 40,60 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
  EXPECT_TRUE(liesAt(state, {15, 100}, {15, 20, 0}));
  EXPECT_TRUE(liesAt(state, {85, 100}, {85, 100, 0}));
  EXPECT_TRUE(isAbove(state, {15, 90}, {15, 30}));
}

TEST(Fold, OfBothArmsWithOneSegmentMakesOneFoldLine) {
  const FoldedState state = run(
      "polygon 0,0 100,0 100,100 70,100 70,30 30,30 30,100 0,100; fold A valley -5,60 105,60 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 3u);
  EXPECT_EQ(anglesOf(state, "A"), (std::vector<double>{180, 180}));
}

TEST(Fold, AcrossAHoleMakesTwoHinges) {
  const FoldedState state =
      run("polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60; fold A valley 50,0 50,100 "
          "left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Hinge), 2u);
  EXPECT_NEAR(areaOf(state), 9600, 1e-8);
}

TEST(Fold, BesideAHoleKeepsTheHole) {
  const FoldedState state =
      run("polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60; fold A valley 20,0 20,100 "
          "left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
  EXPECT_NEAR(areaOf(state), 9600, 1e-8);
}

TEST(Fold, HalvesADisc) {
  const FoldedState state = run("disc 100; fold A valley 50,-5 50,105 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
  for (const FacetId f : {facetOf(state, {25, 50}), facetOf(state, {75, 50})}) {
    EXPECT_NEAR(kiri::areaOf(regionOf(state.pattern, f)), std::numbers::pi * 1250, 1e-4);
  }
}

TEST(Fold, AlongAnEdgeOfThePatternSplitsNothing) {
  const FoldedState state = run("square 100; edge 50,0 50,100; fold A valley 50,0 50,100 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
  EXPECT_EQ(anglesOf(state, "A"), (std::vector<double>{180}));
  EXPECT_TRUE(liesAt(state, {0, 50}, {100, 50, 0}));
}

TEST(Fold, ThroughAVertexMakesNoSecondVertex) {
  const FoldedState state =
      run("square 100; edge 50,0 50,100; edge 0,50 100,50; fold A valley 0,0 100,100 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(state.pattern.vertices.size(), 9u);
}

TEST(Fold, NamesItselfAfterTheStep) {
  const FoldedState state = run("square 100; turn; fold valley 50,0 50,100 left");
  ASSERT_EQ(state.lines.size(), 1u);
  EXPECT_EQ(state.lines.front().name, "fold 2");
}

TEST(Fold, LineOnThePaperIsInTheFrameOfTheNamedFacet) {
  // After the fold the upper left lies over the lower right; the line runs on the upper one.
  const FoldedState state =
      run("square 100; fold A valley 0,0 100,100 left; fold B valley 0,60 40,100 to 5,95 in 20,80 "
          "top 1");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 3u);
  EXPECT_TRUE(liesAt(state, {0, 100}, {60, 40, 0}));
}

}  // namespace
}  // namespace kiri::test
