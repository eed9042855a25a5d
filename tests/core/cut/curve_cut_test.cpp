// Cuts along B-splines: exact, through several layers, at any step (thesis 4.4).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/expect.h"
#include "tests/support/margin_reference.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

const char* const kRing = "curve @model 70,50 64,64 50,70 36,64 30,50 36,36 50,30 64,36 closed ";
const std::vector<Vec2> kRingControls = {{70, 50}, {64, 64}, {50, 70}, {36, 64},
                                         {30, 50}, {36, 36}, {50, 30}, {64, 36}};
const char* const kArch = "curve @model -20,40 10,70 40,55 60,80 90,60 120,75 ";
const std::vector<Vec2> kArchControls = {{-20, 40}, {10, 70}, {40, 55},
                                         {60, 80},  {90, 60}, {120, 75}};

/// Area under a chain of pieces, by the trapezoid rule on many chords.
double ringArea(const std::vector<Piece>& ring) {
  double twice = 0;
  for (const Piece& piece : ring) {
    Vec2 before = piece.p[0];
    for (int i = 1; i <= 2000; ++i) {
      const double t = i / 2000.0;
      const double s = 1 - t;
      const Vec2 p = piece.p[0] * (s * s * s) + piece.p[1] * (3 * s * s * t) +
                     piece.p[2] * (3 * s * t * t) + piece.p[3] * (t * t * t);
      twice += cross(before, p);
      before = p;
    }
  }
  return std::abs(twice) / 2;
}

TEST(CurveCut, ClosedInOneFacetKeepsTheInsideOrTheOutside) {
  const double ring = ringArea(closedSplinePieces(kRingControls));
  const FoldedState inside = run(std::string("square 100; ") + kRing + "keep 50,50");
  EXPECT_TRUE(isClean(inside));
  EXPECT_NEAR(test::areaOf(inside), ring, 1e-3);
  const FoldedState outside = run(std::string("square 100; ") + kRing + "keep 5,5");
  EXPECT_TRUE(isClean(outside));
  EXPECT_NEAR(test::areaOf(outside), 10000 - ring, 1e-3);
  EXPECT_NEAR(test::areaOf(inside) + test::areaOf(outside), 10000, 1e-9);
}

TEST(CurveCut, KeepsBothPartsWhenNothingIsNamed) {
  const FoldedState state = run(std::string("square 100; ") + kRing);
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 2u);
  EXPECT_NEAR(test::areaOf(state), 10000, 1e-9);
}

TEST(CurveCut, FollowsTheSplineExactly) {
  const FoldedState ring = run(std::string("square 100; ") + kRing + "keep 50,50");
  EXPECT_LT(worstMarginError(ring, closedSplinePieces(kRingControls), {}), 1e-9 * 141);
  const FoldedState arch = run(std::string("square 100; ") + kArch + "keep m:50,10");
  EXPECT_LT(worstMarginError(arch, splinePieces(kArchControls, true), {}), 1e-9 * 141);
  const FoldedState free =
      run("square 100; curve @model -20,40 -10,45 10,70 40,55 60,80 90,60 120,75 130,75 free keep "
          "m:50,10");
  EXPECT_TRUE(isClean(free));
  const std::vector<Vec2> controls = {{-20, 40}, {-10, 45}, {10, 70},  {40, 55},
                                      {60, 80},  {90, 60},  {120, 75}, {130, 75}};
  EXPECT_LT(worstMarginError(free, splinePieces(controls, false), {}), 1e-9 * 141);
}

TEST(CurveCut, OpenFromBorderToBorderSeparates) {
  const FoldedState low = run(std::string("square 100; ") + kArch + "keep m:50,10");
  const FoldedState high = run(std::string("square 100; ") + kArch + "keep m:50,95");
  EXPECT_TRUE(isClean(low));
  EXPECT_TRUE(isClean(high));
  EXPECT_EQ(facetCount(low), 1u);
  EXPECT_NEAR(test::areaOf(low) + test::areaOf(high), 10000, 1e-9);
}

TEST(CurveCut, ThroughFourLayersConservesAreaAndFollowsTheReflectedCurve) {
  const std::string folds =
      "square 100; fold A valley 50,-100 50,200 left; fold B valley @model -100,50 200,50 left; ";
  const std::string cut = "curve @model 40,20 60,35 75,20 85,30 95,10 120,15 ";
  const FoldedState all = run(folds + cut);
  EXPECT_TRUE(isClean(all));
  EXPECT_NEAR(test::areaOf(all), 10000, 1e-8);
  const FoldedState kept = run(folds + cut + "keep m:60,45");
  EXPECT_TRUE(isClean(kept));
  const std::vector<DrawnFold> drawn = {{{50, -100}, {50, 200}}, {{-100, 50}, {200, 50}}};
  const std::vector<Vec2> controls = {{40, 20}, {60, 35}, {75, 20}, {85, 30}, {95, 10}, {120, 15}};
  EXPECT_LT(worstMarginError(kept, splinePieces(controls, true), drawn), 1e-9 * 141);
  const FoldedState open = after(kept, "unfold all");
  EXPECT_TRUE(isClean(open));
  EXPECT_LT(worstMarginError(open, splinePieces(controls, true), drawn), 1e-9 * 141);
  EXPECT_EQ(pieceCount(open), 1u);
}

TEST(CurveCut, OfOneLayerLeavesTheOther) {
  const std::string folds = "square 100; fold A valley 50,0 50,100 left; ";
  const FoldedState state =
      run(folds + "curve @model 90,50 80,65 65,60 60,50 70,35 85,40 closed top 1 keep m:55,5");
  EXPECT_TRUE(isClean(state));
  EXPECT_LT(test::areaOf(state), 10000 - 300);
  EXPECT_EQ(facetOf(state, {75, 50}), facetOf(state, {99, 1}));
  EXPECT_FALSE(facetAt(state.pattern, {25, 50}).has_value());
}

TEST(CurveCut, AcrossAnEarlierCurve) {
  const FoldedState state = run(std::string("square 100; ") + kArch +
                                "keep m:50,10; curve @model 20,-10 30,30 15,60 40,110 keep m:90,5");
  EXPECT_TRUE(isClean(state));
  const FoldedState all = run(std::string("square 100; ") + kArch +
                              "keep m:50,10; curve @model 20,-10 30,30 15,60 40,110");
  EXPECT_TRUE(isClean(all));
  EXPECT_NEAR(test::areaOf(all),
              test::areaOf(run(std::string("square 100; ") + kArch + "keep m:50,10")), 1e-9);
  EXPECT_EQ(pieceCount(all), 2u);
}

TEST(CurveCut, RingsThatCrossGiveFourRegions) {
  const FoldedState state =
      run("square 100; curve @model 60,50 54,64 40,70 26,64 20,50 26,36 40,30 54,36 closed;"
          "curve @model 80,50 74,64 60,70 46,64 40,50 46,36 60,30 74,36 closed");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 4u);
  EXPECT_NEAR(test::areaOf(state), 10000, 1e-8);
}

TEST(CurveCut, MayBeFoldedAndTornAfterwards) {
  const std::string arch = std::string("square 100; ") + kArch + "keep m:50,10; ";
  const FoldedState folded = run(arch + "fold A valley 50,-10 50,110 left");
  EXPECT_TRUE(isClean(folded));
  EXPECT_EQ(facetCount(folded), 2u);
  const FoldedState oblique =
      run(arch + "fold A valley 0,30 100,50 left; fold B mountain @model 30,-50 40,150 left");
  EXPECT_TRUE(isClean(oblique));
  EXPECT_NEAR(test::areaOf(oblique), test::areaOf(run(arch)), 1e-9);
  const FoldedState torn = after(folded, "unfold all; tear 50,0 50,30");
  EXPECT_TRUE(isClean(torn));
  EXPECT_EQ(edgeCount(torn, EdgeKind::Tear), 1u);
  const FoldedState apart =
      run(arch + "fold A valley 50,-10 50,110 left; unfold all; tear 50,0 50,100");
  EXPECT_EQ(edgeCount(apart, EdgeKind::Tear) + edgeCount(apart, EdgeKind::Hinge), 1u);
}

TEST(CurveCut, OfADiscFollowsBothCurves) {
  const FoldedState state =
      run("disc 100; fold A valley 50,-10 50,110 left; curve @model 40,60 60,75 80,60 110,80 keep "
          "m:60,20; unfold all");
  EXPECT_TRUE(isClean(state));
}

TEST(CurveCut, ThatEndsAlongACreaseLeavesItTheOneWayItIsSeen) {
  // At its end the curve, the crease up and the crease down meet; two of them leave in one
  // direction.
  for (const char* edges : {"edge 50,0 50,100", "edge 50,0 50,100; tear 50,0 50,50",
                            "edge 50,0 50,100; edge 0,50 100,50"}) {
    SCOPED_TRACE(edges);
    const FoldedState state =
        run(std::string("square 100; ") + edges + "; curve 75,0 25,75 50,50 50,25 in 75,25");
    EXPECT_TRUE(isClean(state));
    EXPECT_NEAR(areaOf(state), 10000, 1e-6);
    const FoldedState mirrored =
        run(std::string("square 100; ") + edges + "; curve 25,0 75,75 50,50 50,25 in 25,25");
    EXPECT_TRUE(isClean(mirrored));
    EXPECT_EQ(facetCount(mirrored), facetCount(state));
  }
}

TEST(CurveCut, ThatCrossesItselfIsRefused) {
  EXPECT_TRUE(failsWith(
      tryRun("square 100; curve @model -20,50 110,50 110,90 20,90 20,10 50,-30 keep m:2,2"),
      ErrorCode::CurveCrossesItself, ""));
}

TEST(CurveCut, ThatEndsInsideDoesNotSeparate) {
  EXPECT_TRUE(failsWith(tryRun("square 100; curve @model -20,50 10,50 30,60 50,50 keep m:2,2"),
                        ErrorCode::DoesNotSeparate, ""));
}

TEST(CurveCut, BesideThePaperMissesIt) {
  EXPECT_TRUE(failsWith(tryRun("square 100; curve @model 200,50 210,50 230,60 250,50 keep m:2,2"),
                        ErrorCode::MissesPaper, ""));
}

TEST(CurveCut, WithTooFewControlsIsRefused) {
  EXPECT_TRUE(failsWith(tryRun("square 100; curve @model -20,50 10,50 130,60 keep m:2,2"),
                        ErrorCode::BadValue, "4"));
  EXPECT_TRUE(failsWith(tryRun("square 100; curve @model -20,50 10,50 closed keep m:2,2"),
                        ErrorCode::BadValue, "3"));
}

}  // namespace
}  // namespace kiri::test
