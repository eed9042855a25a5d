// Tearing along edges and mending (thesis 4.2).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

const char* const kHalved = "square 100; fold A valley 50,0 50,100 left; unfold all; ";

FoldedState halved(const std::string& steps) { return run(kHalved + steps); }

TEST(Tear, ToTheOtherBorderGivesTwoPieces) {
  const FoldedState state = halved("tear 50,100 50,0");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 2u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Hinge), 0u);
  EXPECT_NEAR(areaOf(state), 10000, 1e-9);
}

TEST(Tear, PartwaySplitsTheHingeAtThePoint) {
  const FoldedState state = halved("tear 50,100 50,40");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 1u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Hinge), 1u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Tear), 1u);
  bool hasVertex = false;
  for (const Vec2 v : state.pattern.vertices) hasVertex = hasVertex || distance(v, {50, 40}) < 1e-9;
  EXPECT_TRUE(hasVertex);
}

TEST(Tear, LetsAFlapMoveByItself) {
  const FoldedState state =
      halved("tear 50,100 50,50; fold B valley 50,50 105,50 left facets 75,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {75, 100}, {75, 0, 0}));
  EXPECT_TRUE(liesAt(state, {25, 100}, {25, 100, 0}));
  EXPECT_TRUE(isAbove(state, {75, 90}, {75, 10}));
}

TEST(Tear, AlongSeveralEdgesTurnsCorners) {
  const FoldedState state =
      run("square 100; edge 50,0 50,100; edge 0,50 100,50; tear 50,0 50,50 100,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 2u);
  EXPECT_EQ(edgeCount(state, EdgeKind::Tear), 2u);
}

TEST(Tear, InAFoldedModelTearsAllLayersOrTheChosenOnes) {
  // Both layers carry an edge at the same place of the model.
  const std::string folded =
      "square 100; fold A valley 50,0 50,100 left; edge @model 40,50 110,50; ";
  const FoldedState both = run(folded + "tear @model 100,50 70,50");
  EXPECT_EQ(edgeCount(both, EdgeKind::Tear), 2u);
  EXPECT_TRUE(isSound(both));
  const FoldedState top = run(folded + "tear @model 100,50 70,50 top 1");
  EXPECT_EQ(edgeCount(top, EdgeKind::Tear), 1u);
  const FoldedState chosen = run(folded + "tear @model 100,50 70,50 facets p:75,25");
  EXPECT_EQ(edgeCount(chosen, EdgeKind::Tear), 1u);
}

TEST(Tear, AlongAPathOnThePaperLeavesWhatLiesOverIt) {
  const std::string folded =
      "square 100; fold A valley 50,0 50,100 left; edge @model 40,50 110,50; ";
  const FoldedState own = run(folded + "tear 100,50 70,50");
  EXPECT_EQ(edgeCount(own, EdgeKind::Tear), 1u);
  EXPECT_TRUE(isSound(own));
  const FoldedState all = run(folded + "tear 100,50 70,50 layers all");
  EXPECT_EQ(edgeCount(all, EdgeKind::Tear), 2u);
  EXPECT_EQ(edgeCount(run(folded + "tear 100,50 70,50 top 1"), EdgeKind::Tear), 1u);
  // Mending takes the same words.
  EXPECT_EQ(edgeCount(after(all, "mend 100,50 70,50"), EdgeKind::Tear), 1u);
  EXPECT_EQ(edgeCount(after(all, "mend 100,50 70,50 layers all"), EdgeKind::Tear), 0u);
  EXPECT_EQ(edgeCount(after(all, "mend @model 100,50 70,50"), EdgeKind::Tear), 0u);
}

TEST(Tear, OfANarrowSlitInsideKeepsOnePiece) {
  const FoldedState state = run("square 100; edge 50,0 50,100; edge 0,50 100,50; tear 50,50 50,30");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(pieceCount(state), 1u);
}

TEST(Tear, WhereThereIsNoEdgeIsRefused) {
  const Result<FoldedState> result = tryRun("square 100; tear 50,100 50,50");
  EXPECT_TRUE(failsWith(result, ErrorCode::NothingToDo, "(50, 100)"));
}

TEST(Mend, RestoresTheHinge) {
  const FoldedState before = halved("");
  const FoldedState after = halved("tear 50,100 50,0; mend");
  EXPECT_TRUE(isClean(after));
  EXPECT_EQ(pieceCount(after), 1u);
  EXPECT_EQ(edgeCount(after, EdgeKind::Tear), 0u);
  EXPECT_EQ(anglesOf(after, "A"), anglesOf(before, "A"));
  const FoldedState refolded = kiri::test::after(after, "refold all");
  EXPECT_TRUE(isClean(refolded));
  EXPECT_TRUE(isAbove(refolded, {25, 50}, {75, 50}));
}

TEST(Mend, RestoresTheLayersOfAFoldedModel) {
  const std::string folded =
      "square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left; ";
  const FoldedState before = run(folded);
  const FoldedState after = run(folded + "tear 50,100 50,50; mend");
  EXPECT_TRUE(isClean(after));
  ASSERT_EQ(facetCount(after), facetCount(before));
  for (std::size_t f = 0; f < before.pattern.facets.size(); ++f) {
    for (std::size_t g = 0; g < before.pattern.facets.size(); ++g) {
      if (f == g) continue;
      const Vec2 a = interiorPointOf(before.pattern, FacetId(f));
      const Vec2 b = interiorPointOf(before.pattern, FacetId(g));
      EXPECT_EQ(isAbove(before, a, b), isAbove(after, a, b));
    }
  }
  for (const Vec2 p : before.pattern.vertices) EXPECT_TRUE(liesAt(after, p, modelOf(before, p)));
}

TEST(Mend, AlongAPathLeavesTheRestTorn) {
  const FoldedState state =
      run("square 100; edge 50,0 50,100; edge 0,50 100,50; tear 50,0 50,100; mend 50,100 50,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(edgeCount(state, EdgeKind::Tear), 1u);
}

TEST(Mend, IsRefusedWhileTheSidesAreApart) {
  const std::string flap = "tear 50,100 50,50; fold B valley 50,50 105,50 left facets 75,50; ";
  EXPECT_TRUE(
      failsWith(tryRun(kHalved + flap + "mend 50,100 50,50"), ErrorCode::CannotMend, "apart"));
  EXPECT_FALSE(tryRun(kHalved + flap + "mend").isOk());
  const FoldedState back = halved(flap + "unfold B; mend");
  EXPECT_EQ(edgeCount(back, EdgeKind::Tear), 0u);
  EXPECT_TRUE(isClean(back));
}

/// The ship of thesis Figure 4.4 up to its mended bow: an inside reverse fold.
const char* const kTuck =
    "square 100; fold OP valley 0,0 100,100 to 20,80; unfold OP; tear 0,0 40,40;"
    "fold QN valley 40,40 0,26.2 to 1,3; fold MN valley 40,40 26.2,0 to 3,1; refold OP; mend";

TEST(Mend, OfATuckTurnsTheCreaseRoundWithinItsFoldLine) {
  const FoldedState tucked = run(kTuck);
  EXPECT_EQ(tucked.collisions.size(), 0u);
  for (std::size_t line = 0; line < tucked.lines.size(); ++line)
    EXPECT_EQ(amountOf(tucked, FoldLineId(line)), 180) << tucked.lines[line].name;
  int mountains = 0;
  for (const Edge& edge : tucked.pattern.edges) mountains += edge.angle == -180 ? 1 : 0;
  EXPECT_EQ(mountains, 1);
}

TEST(Mend, WithNothingTornHasNothingToDo) {
  EXPECT_TRUE(failsWith(tryRun(std::string(kHalved) + "mend"), ErrorCode::NothingToDo, "torn"));
}

}  // namespace
}  // namespace kiri::test
