// Layers as folds land on them from above and from below, and as the model is turned over.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

// Places on a strip 120 x 20 that is folded in thirds.
constexpr Vec2 kLeft{10, 10};
constexpr Vec2 kMiddle{60, 10};
constexpr Vec2 kRight{110, 10};

TEST(Landing, TwoValleysPutTheLastFlapOnTop) {
  const FoldedState state =
      run("rectangle 120 20; fold A valley 40,0 40,20 left; fold B valley @model 80,0 80,20 right");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(isAbove(state, kLeft, kMiddle));
  EXPECT_TRUE(isAbove(state, kRight, kLeft));
}

TEST(Landing, ValleyAndMountainPutTheMiddleBetween) {
  const FoldedState state = run(
      "rectangle 120 20; fold A valley 40,0 40,20 left; fold B mountain @model 80,0 80,20 right");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(isAbove(state, kLeft, kMiddle));
  EXPECT_TRUE(isAbove(state, kMiddle, kRight));
}

TEST(Landing, FromBelowGoesBeneathWhatLiesThere) {
  const FoldedState state = run(
      "rectangle 120 20; fold A mountain 40,0 40,20 left; fold B mountain @model 80,0 80,20 right");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(isAbove(state, kMiddle, kLeft));
  EXPECT_TRUE(isAbove(state, kLeft, kRight));
}

TEST(Landing, AFlapThatStandsLandsFromTheSideItStoodOn) {
  const FoldedState above =
      run("rectangle 120 20; fold A valley 90 40,0 40,20 left; fold B valley @model 80,0 80,20 "
          "right; angle A 180");
  EXPECT_TRUE(isClean(above));
  EXPECT_TRUE(isAbove(above, kLeft, kRight));
  const FoldedState below =
      run("rectangle 120 20; fold A mountain 90 40,0 40,20 left; fold B valley @model 80,0 80,20 "
          "right; angle A 180");
  EXPECT_TRUE(isClean(below));
  EXPECT_TRUE(isAbove(below, kMiddle, kLeft));
}

TEST(Landing, MovesTheLayersOfAPacketInTurnedOrder) {
  // Two thirds folded together over the last third: what was on top comes to lie below.
  const FoldedState state =
      run("rectangle 120 20; fold A valley 40,0 40,20 left; fold B valley @model 80,0 80,20 left");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(isAbove(state, kLeft, kRight));
  EXPECT_TRUE(isAbove(state, kMiddle, kLeft));
}

TEST(TurningOver, TurnsEveryRelation) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left; "
          "fold C valley @model 75,-10 75,110 right");
  const FoldedState turned = after(state, "turn");
  EXPECT_TRUE(isSound(turned));
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    for (std::size_t g = 0; g < state.pattern.facets.size(); ++g) {
      if (f == g) continue;
      const Vec2 a = interiorPointOf(state.pattern, FacetId(f));
      const Vec2 b = interiorPointOf(state.pattern, FacetId(g));
      EXPECT_NE(isAbove(state, a, b), isAbove(turned, a, b));
    }
  }
}

TEST(TurningOver, TwiceIsTheSame) {
  const FoldedState state = run("square 100; fold A valley 20,0 100,70 left");
  for (const char* twice : {"turn; turn", "turn horizontal; turn horizontal"}) {
    const FoldedState again = after(state, twice);
    EXPECT_TRUE(isClean(again));
    for (const Vec2 p : state.pattern.vertices) EXPECT_TRUE(liesAt(again, p, modelOf(state, p)));
  }
}

TEST(TurningOver, KeepsTheBoxOfTheModel) {
  const FoldedState state = run("rectangle 80 40; turn");
  EXPECT_TRUE(liesAt(state, {0, 0}, {80, 0, 0}));
  EXPECT_TRUE(liesAt(state, {80, 40}, {0, 40, 0}));
  const FoldedState other = run("rectangle 80 40; turn horizontal");
  EXPECT_TRUE(liesAt(other, {0, 0}, {0, 40, 0}));
  EXPECT_TRUE(liesAt(other, {80, 40}, {80, 0, 0}));
}

TEST(TurningOver, MakesTheLowestLayerTheTopOne) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; turn; fold B valley @model 40,70 70,110 to "
          "m:48,98 top 1");
  EXPECT_EQ(facetCount(state), 3u);
  EXPECT_EQ(facetOf(state, {10, 10}), facetOf(state, {10, 95}))
      << "the layer that is now below is whole";
}

TEST(LayersOfFourFlaps, FollowTheOrderOfFolding) {
  const FoldedState state =
      run("polygon 10,0 20,0 20,10 30,10 30,20 20,20 20,30 10,30 10,20 0,20 0,10 10,10;"
          "fold E valley 20,10 20,20 right; fold N valley 20,20 10,20 right;"
          "fold W valley 10,20 10,10 right; fold S valley 10,10 20,10 right");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 5u);
  EXPECT_TRUE(isAbove(state, {15, 25}, {25, 15}));
  EXPECT_TRUE(isAbove(state, {5, 15}, {15, 25}));
  EXPECT_TRUE(isAbove(state, {15, 5}, {5, 15}));
}

}  // namespace
}  // namespace kiri::test
