// Added edges and straight cuts (thesis 4.3 and 4.4).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

TEST(AddEdge, DividesAFacetWithoutFoldingIt) {
  const FoldedState state = run("square 100; edge 0,50 100,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Hinge), 1u);
  EXPECT_TRUE(isFlat(state));
  EXPECT_TRUE(state.lines.empty());
}

TEST(AddEdge, GoesThroughAllLayersOrTheTopOne) {
  const std::string folded = "square 100; fold A valley 50,0 50,100 left; ";
  EXPECT_EQ(facetCount(run(folded + "edge @model 40,50 110,50")), 4u);
  EXPECT_EQ(facetCount(run(folded + "edge @model 40,50 110,50 top 1")), 3u);
  EXPECT_TRUE(isClean(run(folded + "edge @model 40,50 110,50")));
}

TEST(StraightCut, KeepsTheSideOfAPoint) {
  const FoldedState state = run("square 100; cut 50,-10 50,110 keep 25,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 1u);
  EXPECT_NEAR(areaOf(state), 5000, 1e-9);
  EXPECT_FALSE(facetAt(state.pattern, {75, 50}).has_value());
}

TEST(StraightCut, KeepsEverythingWhenNothingIsNamed) {
  const FoldedState state = run("square 100; cut 50,-10 50,110");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 2u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Hinge), 0u);
  EXPECT_NEAR(areaOf(state), 10000, 1e-9);
}

const char* const kFolded = "square 100; fold A valley 50,0 50,100 left; cut @model 75,-10 75,110 ";

TEST(StraightCut, ThroughTwoLayersKeepsTheSideInBoth) {
  const FoldedState state = run(std::string(kFolded) + "keep m:60,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_NEAR(areaOf(state), 5000, 1e-9);
  EXPECT_EQ(pieceCount(state), 1u);
  const FoldedState other = run(std::string(kFolded) + "keep m:90,50");
  EXPECT_TRUE(isClean(other));
  EXPECT_NEAR(areaOf(other), 5000, 1e-9);
  EXPECT_EQ(pieceCount(other), 2u);
}

TEST(StraightCut, KeepsThePieceThatHoldsAPlaceOnThePaper) {
  const FoldedState state = run(std::string(kFolded) + "keep p:95,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_NEAR(areaOf(state), 2500, 1e-9);
  const FoldedState two = run(std::string(kFolded) + "keep p:95,50 p:50,50");
  EXPECT_TRUE(isClean(two));
  EXPECT_NEAR(areaOf(two), 7500, 1e-9);
}

TEST(StraightCut, OfTheTopLayerLeavesTheLowerWhole) {
  const FoldedState state = run(std::string(kFolded) + "top 1 keep m:60,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_NEAR(areaOf(state), 7500, 1e-9);
}

TEST(StraightCut, MayBeFoldedAfterwards) {
  const FoldedState state = run(
      std::string(kFolded) + "keep m:60,50; fold B mountain @model 40,40 110,60 right; unfold all");
  EXPECT_TRUE(isClean(state));
  EXPECT_NEAR(areaOf(state), 5000, 1e-9);
  EXPECT_EQ(facetCount(state), 4u);
}

TEST(StraightCut, AcrossAnOpenFoldCutsOnlyItsPlane) {
  const FoldedState state =
      run("square 100; fold A valley 90 50,0 50,100 left; cut 75,-10 75,110 keep 60,50");
  EXPECT_TRUE(isSound(state));
  EXPECT_NEAR(areaOf(state), 7500, 1e-9);
}

TEST(StraightCut, ThatStopsInsideDoesNotSeparate) {
  EXPECT_TRUE(failsWith(tryRun("square 100; cut 50,-10 50,50 keep m:25,50"),
                        ErrorCode::DoesNotSeparate, "joined"));
  const FoldedState slit = run("square 100; cut 50,-10 50,50");
  EXPECT_TRUE(isClean(slit));
  EXPECT_EQ(facetCount(slit), 1u);
  EXPECT_NEAR(areaOf(slit), 10000, 1e-9);
}

TEST(StraightCut, BesideThePaperMissesIt) {
  EXPECT_TRUE(
      failsWith(tryRun("square 100; cut 150,-10 150,110 keep 25,50"), ErrorCode::MissesPaper, ""));
}

TEST(StraightCut, OfTheWholeSheetLeavesNothing) {
  const Result<FoldedState> result = tryRun("square 100; cut 50,-10 50,110 keep 150,50");
  ASSERT_FALSE(result.isOk());
  EXPECT_TRUE(result.error().code == ErrorCode::NothingLeft ||
              result.error().code == ErrorCode::NotFound)
      << result.error().message;
}

TEST(StraightCut, ThroughAHoleMakesTwoCuts) {
  const FoldedState state = run(
      "polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60; cut 50,-10 50,110 keep 25,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_NEAR(areaOf(state), 4800, 1e-9);
  EXPECT_EQ(facetCount(state), 1u);
}

TEST(StraightCut, AlongACreaseSeparatesTheFacets) {
  const FoldedState state = run("square 100; edge 50,0 50,100; cut 50,-10 50,110 keep 25,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_NEAR(areaOf(state), 5000, 1e-9);
}

// Thesis Fig 4.5: fold AB, cut along CD, fold on along EF.
TEST(StraightCut, IsFollowedByAFoldThroughTheRest) {
  const FoldedState state =
      run("square 100; fold AB valley 0,0 100,100 left; cut @model 60,-10 60,110 keep m:30,10;"
          "fold EF valley @model 30,-5 30,60 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_NEAR(areaOf(state), 3600, 1e-8);
}

}  // namespace
}  // namespace kiri::test
