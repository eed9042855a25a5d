// A crease pattern drawn on the sheet in one step.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

/// Four creases that cross in the middle of a square of 100 mm: a map folded twice.
PatternStep mapPattern() {
  PatternStep step;
  step.vertices = {{50, 0}, {50, 50}, {50, 100}, {0, 50}, {100, 50}};
  step.creases = {{0, 1, Assignment::Valley, 180},
                  {1, 2, Assignment::Valley, 180},
                  {3, 1, Assignment::Mountain, -180},
                  {1, 4, Assignment::Valley, 180}};
  return step;
}

Result<FoldedState> creased(const PatternStep& step) {
  return apply(run("square 100"), Step{step, "", "", ""}, 1);
}

TEST(PatternStep, DrawsItsCreasesFlat) {
  const Result<FoldedState> state = creased(mapPattern());
  ASSERT_TRUE(state.isOk()) << state.error().message;
  EXPECT_TRUE(isClean(*state));
  EXPECT_EQ(facetCount(*state), 4u);
  EXPECT_EQ(edgeCount(*state, EdgeKind::Hinge), 4u);
  EXPECT_DOUBLE_EQ(areaOf(*state), 10000);
}

TEST(PatternStep, JoinsStraightCreasesOfEqualTurnToOneLine) {
  PatternStep step = mapPattern();
  step.name = "map";
  const FoldedState state = *creased(step);
  ASSERT_EQ(state.lines.size(), 2u);
  EXPECT_EQ(state.lines[0].name, "map 1");
  EXPECT_EQ(state.lines[1].name, "map 2");
  step.creases[3].angle = 90;
  EXPECT_EQ(creased(step)->lines.size(), 3u);
}

TEST(PatternStep, ItsFoldLinesFoldLikeOthers) {
  const FoldedState state = *creased(mapPattern());
  const Result<FoldedState> folded = tryAfter(state, "angle p:50,25 180");
  ASSERT_TRUE(folded.isOk()) << folded.error().message;
  EXPECT_TRUE(isClean(*folded));
  EXPECT_DOUBLE_EQ(amountOf(*folded, "crease 1"), 180);
}

TEST(PatternStep, CutsAreEdgesWithPaperOnBothSides) {
  PatternStep step = mapPattern();
  step.creases[0].assignment = Assignment::Cut;
  const Result<FoldedState> state = creased(step);
  ASSERT_TRUE(state.isOk()) << state.error().message;
  EXPECT_TRUE(isClean(*state));
  EXPECT_EQ(edgeCount(*state, EdgeKind::Cut), 1u);
  EXPECT_EQ(facetCount(*state), 4u);
}

TEST(PatternStep, RefusesWhatIsNoPlanarMapWithThePlace) {
  PatternStep crossing = mapPattern();
  crossing.creases = {{0, 2, Assignment::Valley, 180}, {3, 4, Assignment::Valley, 180}};
  EXPECT_TRUE(failsWith(creased(crossing), ErrorCode::BadValue, "at (50, 50) mm without a vertex"));
  PatternStep dangling = mapPattern();
  dangling.creases.resize(1);
  EXPECT_TRUE(failsWith(creased(dangling), ErrorCode::WouldStretch, "ends inside a facet"));
  PatternStep outside = mapPattern();
  outside.vertices[4] = {120, 50};
  EXPECT_TRUE(failsWith(creased(outside), ErrorCode::BadValue, "lies outside of the sheet"));
  PatternStep missing = mapPattern();
  missing.creases[0].from = 5;
  EXPECT_TRUE(failsWith(creased(missing), ErrorCode::BadValue, "has 5 vertices"));
  PatternStep twice = mapPattern();
  twice.creases.push_back({2, 1, Assignment::Mountain, -180});
  EXPECT_TRUE(failsWith(creased(twice), ErrorCode::BadValue, "is drawn twice"));
  PatternStep same = mapPattern();
  same.vertices[2] = {50, 50};
  EXPECT_TRUE(failsWith(creased(same), ErrorCode::BadValue, "are one place"));
}

TEST(PatternStep, NeedsASheetWithoutCreases) {
  const FoldedState folded = run("square 100; fold valley 50,0 50,100 left");
  EXPECT_TRUE(failsWith(apply(folded, Step{mapPattern(), "", "", ""}, 2), ErrorCode::BadValue,
                        "put the pattern before the other steps"));
}

}  // namespace
}  // namespace kiri::test
