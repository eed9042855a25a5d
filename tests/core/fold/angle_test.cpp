// Setting angles again, unfolding and refolding: what is free, what is locked, what collides.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

constexpr const char* kCross = "square 100; fold A valley 50,0 50,100 left; fold B valley ";

std::string cross(const std::string& angle) { return kCross + angle + " @model 40,50 110,50 left"; }

TEST(Angle, OpensAFoldAgain) {
  const FoldedState state = run("square 100; fold A valley 50,0 50,100 left; angle A 90");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {0, 50}, {50, 50, 50}));
  EXPECT_DOUBLE_EQ(amountOf(state, "A"), 90);
}

TEST(Angle, NegativeFoldsTheOtherWay) {
  const FoldedState state = run("square 100; fold A valley 50,0 50,100 left; angle A -90");
  EXPECT_TRUE(liesAt(state, {0, 50}, {50, 50, -50}));
  const FoldedState flat = run("square 100; fold A valley 50,0 50,100 left; angle A -180");
  EXPECT_TRUE(isSound(flat));
  EXPECT_TRUE(isAbove(flat, {75, 50}, {25, 50}));
}

TEST(Angle, NamesAFoldLineByAPlaceOnIt) {
  const FoldedState state = run("square 100; fold A valley 50,0 50,100 left; angle 50,30 0");
  EXPECT_DOUBLE_EQ(amountOf(state, "A"), 0);
}

TEST(Angle, OfTheFirstLineOfACrossIsFreeWhileTheSecondLiesFlat) {
  const FoldedState state = after(run(cross("180")), "angle B 0; angle A 60");
  EXPECT_TRUE(isClean(state));
  EXPECT_DOUBLE_EQ(amountOf(state, "A"), 60);
}

TEST(Angle, OfTheFirstLineOfACrossIsLockedWhileTheSecondStands) {
  EXPECT_TRUE(failsWith(tryAfter(run(cross("60")), "angle A 90"), ErrorCode::Locked, "B"));
}

TEST(Angle, OfTheFirstLineOfACrossCollidesOrIsLockedWhenTheSecondIsFolded) {
  const Result<FoldedState> result = tryAfter(run(cross("180")), "angle A 90");
  if (!result) {
    EXPECT_TRUE(failsWith(result, ErrorCode::Locked, ""));
    return;
  }
  ASSERT_FALSE(result->collisions.empty());
  const CollisionMoment moment = result->collisions.front().moment;
  EXPECT_TRUE(moment == CollisionMoment::Start || moment == CollisionMoment::Hinge);
}

TEST(Angle, OfTheSecondLineOfACrossIsFree) {
  for (const char* angle : {"0", "30", "90", "179", "-40"}) {
    const FoldedState state = after(run(cross("180")), std::string("angle B ") + angle);
    EXPECT_TRUE(isClean(state)) << angle;
  }
}

// Fig 4.2 a,b: AB, then both layers along CD; AB opened first pushes p1 and p2 through what lies on
// them.
TEST(Angle, OpeningAnInnerFoldFirstIsReportedAsACollisionAtTheStart) {
  const Result<FoldedState> result = tryRun(
      "square 100; fold AB valley 50,0 50,100 left; fold CD valley @model 80,-10 80,110 right; "
      "angle AB 0");
  ASSERT_TRUE(result.isOk());
  ASSERT_FALSE(result->collisions.empty());
  EXPECT_EQ(result->collisions.front().moment, CollisionMoment::Start);
  EXPECT_EQ(result->collisions.front().step, 3u);
  EXPECT_FALSE(result->collisions.front().message.empty());
  EXPECT_EQ(facetCount(*result), 4u);
  EXPECT_NEAR(areaOf(*result), 10000, 1e-8);
}

TEST(Angle, ACollisionMayBeCarriedOnWith) {
  const FoldedState state =
      run("square 100; fold AB valley 50,0 50,100 left; fold CD valley @model 80,-10 80,110 right; "
          "angle AB 0;"
          "turn; rotate 30; angle AB 180; angle CD 0; unfold all");
  EXPECT_FALSE(state.collisions.empty());
  EXPECT_LT(stretchOf(state), 1e-7);
}

TEST(Unfold, AllInOrderOpensTheSheet) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B mountain @model 40,50 110,50 left;"
          "fold C valley @model 75,-10 75,110 right; unfold all");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(state.layers.sets().size(), 1u);
  for (const Vec2 p : {Vec2{0, 0}, Vec2{100, 0}, Vec2{100, 100}, Vec2{0, 100}, Vec2{30, 80}}) {
    const Vec3 there = modelOf(state, p);
    const Vec3 middle = modelOf(state, {60, 40});
    EXPECT_NEAR(distance(there, middle), distance(p, {60, 40}), 1e-9);
  }
}

TEST(Unfold, ThenRefoldGivesTheSameLayers) {
  const FoldedState folded =
      run("square 100; fold A valley 50,0 50,100 left; fold B mountain @model 40,50 110,50 left;"
          "fold C valley @model 75,-10 75,110 right");
  const FoldedState again = after(folded, "unfold all; refold all");
  EXPECT_TRUE(isClean(again));
  for (const FacetId f :
       {facetOf(folded, {10, 10}), facetOf(folded, {10, 90}), facetOf(folded, {60, 60})}) {
    for (std::size_t g = 0; g < folded.pattern.facets.size(); ++g) {
      const Vec2 a = interiorPointOf(folded.pattern, f);
      const Vec2 b = interiorPointOf(folded.pattern, FacetId(g));
      if (f == FacetId(g)) continue;
      EXPECT_EQ(isAbove(folded, a, b), isAbove(again, a, b));
    }
  }
}

TEST(Unfold, OneLineLeavesTheOthers) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left; "
          "unfold B");
  EXPECT_TRUE(isClean(state));
  EXPECT_DOUBLE_EQ(amountOf(state, "A"), 180);
  EXPECT_DOUBLE_EQ(amountOf(state, "B"), 0);
}

TEST(Unfold, TogetherOpensAFan) {
  const FoldedState folded =
      run("rectangle 200 100; fold A valley 100,0 140,100 right; fold B valley 100,0 180,100 to "
          "190,20 in 190,20 top 1");
  EXPECT_TRUE(isSound(folded));
  const FoldedState open = after(folded, "unfold all together");
  EXPECT_TRUE(isClean(open));
  EXPECT_TRUE(liesAt(open, {0, 100}, {0, 100, 0}));
  EXPECT_TRUE(liesAt(open, {200, 0}, {200, 0, 0}));
  const FoldedState again = after(open, "refold all together");
  EXPECT_TRUE(isSound(again));
  EXPECT_DOUBLE_EQ(amountOf(again, "A"), 180);
  EXPECT_DOUBLE_EQ(amountOf(again, "B"), 180);
}

TEST(Refold, RestoresAnAngleThatWasNotFlat) {
  const FoldedState state =
      run("square 100; fold A valley 70 50,0 50,100 left; unfold all; refold all");
  EXPECT_DOUBLE_EQ(amountOf(state, "A"), 70);
}

TEST(Collision, FoldingTheLowerLayerUpwardsIsReported) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley @model 110,70 70,110 to "
          "m:98,98 facets p:75,50");
  ASSERT_FALSE(state.collisions.empty());
  EXPECT_EQ(state.collisions.front().moment, CollisionMoment::Start);
}

TEST(Collision, IsNotReportedForAFoldThatIsFree) {
  for (const char* text :
       {"square 100; fold A valley 50,0 50,100 left; fold B valley @model 75,0 75,100 right",
        "square 100; fold A valley 50,0 50,100 left; fold B mountain @model 75,0 75,100 right",
        "square 100; fold A valley 25,0 25,100 left; fold B valley 75,0 75,100 right",
        "square 100; fold A valley 50,0 50,100 left; fold B valley @model 75,0 75,100 left top "
        "1"}) {
    const Result<FoldedState> result = tryRun(text);
    if (result) {
      EXPECT_TRUE(isClean(*result)) << text;
    }
  }
}

}  // namespace
}  // namespace kiri::test
