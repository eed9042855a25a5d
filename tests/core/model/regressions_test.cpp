// Models that once went wrong, most of them found by sweeps of random steps (the seed is named).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// Applies what applies; every state must be sound until something collides, and hold together
/// after that.
void walk(const char* text) {
  const Model model = modelOf(text);
  FoldedState state = startOf(model);
  int number = 0;
  for (const Step& step : model.steps) {
    Result<FoldedState> next = apply(state, step, ++number);
    if (!next) continue;
    state = std::move(next).value();
    if (state.collisions.empty()) {
      ASSERT_TRUE(isSound(state)) << "step " << number << ": " << textOf(step);
    } else {
      ASSERT_EQ(joined(poseViolations(state)), "") << "step " << number;
    }
    ASSERT_TRUE(kiri::areaOf(state.pattern) > 0);
    for (std::size_t f = 0; f < state.pattern.facets.size(); ++f)
      interiorPointOf(state.pattern, FacetId(f));
  }
}

TEST(Regression, AHoleBelongsToTheSmallestRingAroundIt) {  // seed 576
  walk(
      "polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,65 40,60;"
      "fold A mountain @model -50,200 200,-50 right facets p:84,51;"
      "curve @model 140.61657161376922,110 105.07684874677336,156.40176918042573 "
      "58.008199111221465,133.24340389317732 "
      "63.765424533635894,90.9394652195204 101.74849342781769,73.841855190593805 closed");
}

TEST(Regression, ALineThatGrazesADiscLeavesNoSliver) {  // seed 373
  walk(
      "disc 100; fold A mountain @model 40.220100063498315,124.81731243200474 "
      "-12.769201067544309,46.419311130297018 "
      "right facets p:49.99,50");
}

TEST(Regression, ACutAfterACurveThroughAHoleLeavesNoSliver) {  // seed 870
  walk(
      "polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,65 40,60;"
      "curve @model -124.77027411185506,-233.22563616359443 "
      "-94.621539499827804,-144.80124117419095 "
      "-24.869423095678915,-79.879258374240067 -13.797049155131674,19.865899420954317 "
      "68.067881017201998,77.599598567548441 108.24243601070295,160.07422481296854 "
      "152.34829409286181,240.21584055650032 187.53486793096815,325.65055717305694 free;"
      "fold A mountain 92.560847172987053,-9.0346962739018117 "
      "-8.0542665894464598,90.406551740023176 "
      "to p:43.461505498054713,17.164718636404761 in 36.585201418327735,83.899605514714338;"
      "cut @model -11.105410412284975,31.818710481832923 117.95264971246901,117.49532512178266 "
      "facets p:76.666206078762443,48.792978022589764 p:37.179683629191082,14.561218258266125;"
      "fold B mountain @model -82.499999999999972,182.5 154.99999999999994,-54.999999999999979 "
      "right; turn");
}

TEST(Regression, AChordBetweenReflexCornersIsNotTheWholeLine) {
  const FoldedState state =
      run("polygon 10,0 20,0 20,10 30,10 30,20 20,20 20,30 10,30 10,20 0,20 0,10 10,10; edge 20,10 "
          "20,20");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(facetCount(state), 2u);
}

TEST(Regression, ALongLineFindsTheSmallPaperItCrosses) {
  EXPECT_TRUE(isClean(run("square 10; fold valley @model -1000,1 1003,4 left")));
}

TEST(Regression, AFlapThatChangesSidesUnderALandedLayerCollides) {  // seed 5742
  const FoldedState state =
      run("polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,65 40,60;"
          "fold A mountain 135.14942712425736 46.619878618873877,15.833015971325578 "
          "92.039367028015093,66.053199412026743 "
          "left top 4; turn;"
          "fold B mountain @model -29.729396031437062,258.03765254274106 "
          "173.9471364958832,-199.91836407952599 left;"
          "angle A -151.92861545704551");
  EXPECT_FALSE(state.collisions.empty());
}

TEST(Regression, MendingThroughALayerIsRefused) {
  // A strip halved and torn along the crease, with a flap of the lower half folded in between.
  const Result<FoldedState> result = tryRun(
      "rectangle 120 20; fold A valley 40,0 40,20 left; tear 40,0 40,20;"
      "fold B valley @model 60,-5 60,25 right facets p:110,10; mend");
  if (result) {
    EXPECT_TRUE(!result->collisions.empty() || isSound(*result));
  } else {
    EXPECT_TRUE(failsWith(result, ErrorCode::CannotMend, "between"));
  }
}

TEST(Regression, EdgesThatEndAtAHoleMayBeTorn) {  // seed 2540
  const FoldedState state =
      run("polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,65 40,60; edge 100,0 60,40; tear "
          "100,0 60,40");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 1u);
  EXPECT_EQ(facetCount(state), 1u);
}

}  // namespace
}  // namespace kiri::test
