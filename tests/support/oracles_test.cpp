// The oracles must find what is wrong: right states are spoiled on purpose.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/expect.h"
#include "tests/support/margin_reference.h"
#include "tests/support/model_text.h"
#include "tests/support/order_check.h"
#include "tests/support/plane_overlap.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

/// The state with the list of its only layer-set in another order.
FoldedState reordered(FoldedState state, const std::vector<Vec2>& upward) {
  LayerSet set = state.layers.sets().front();
  set.exceptions.clear();
  set.upward.clear();
  for (const Vec2 p : upward) set.upward.push_back(facetOf(state, p));
  if (set.normal.z < 0) std::reverse(set.upward.begin(), set.upward.end());
  state.layers = LayerOrder({set});
  return state;
}

bool mentions(const std::vector<std::string>& found, const std::string& word) {
  return std::any_of(found.begin(), found.end(),
                     [&word](const std::string& s) { return s.find(word) != std::string::npos; });
}

TEST(Overlap, OfPolygonsWithHolesIsExact) {
  const Loops square = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  const Loops ring = {{{5, 0}, {15, 0}, {15, 10}, {5, 10}}, {{6, 2}, {8, 2}, {8, 4}, {6, 4}}};
  EXPECT_NEAR(commonOf({&square, &ring}).area, 46, 1e-12);
  const Loops diamond = {{{10, 5}, {5, 10}, {0, 5}, {5, 0}}};
  EXPECT_NEAR(commonOf({&square, &diamond}).area, 50, 1e-12);
  EXPECT_NEAR(commonOf({&square, &diamond, &ring}).area, 25 - 3.5, 1e-12);
  const Loops apart = {{{20, 20}, {30, 20}, {30, 30}}};
  EXPECT_EQ(commonOf({&square, &apart}).area, 0);
}

TEST(OrderCheck, FindsAValleyWithItsFacetsTheWrongWayRound) {
  const FoldedState state = run("square 100; fold A valley 50,0 50,100 left");
  EXPECT_TRUE(isSound(state));
  EXPECT_TRUE(mentions(orderViolations(reordered(state, {{25, 50}, {75, 50}})), "wrong way round"));
}

TEST(OrderCheck, FindsALayerBetweenTheHalvesOfAFold) {
  // Thirds of a strip, the right one tucked between the other two: its own crease is in the way of
  // nothing, but the fold of the left one goes through it.
  const FoldedState state =
      run("rectangle 120 20; fold A valley 40,0 40,20 left; fold B valley @model 80,0 80,20 right");
  EXPECT_TRUE(isSound(state));
  const FoldedState between = reordered(state, {{60, 10}, {110, 10}, {10, 10}});
  EXPECT_TRUE(isSound(between)) << "tucking in is possible: both flaps end on the other's crease";
  // The same with a right flap that reaches past the left crease.
  const FoldedState longer =
      run("rectangle 100 20; fold A valley 30,0 30,20 left; fold B valley @model 60,0 60,20 right");
  EXPECT_TRUE(isSound(longer));
  EXPECT_TRUE(mentions(orderViolations(reordered(longer, {{45, 10}, {80, 10}, {10, 10}})),
                       "passes through"));
}

TEST(OrderCheck, FindsInterleavedFolds) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left");
  EXPECT_TRUE(isSound(state));
  // Bottom to top: lower right, lower left, upper left, upper right.
  EXPECT_TRUE(isSound(reordered(state, {{75, 25}, {25, 25}, {25, 75}, {75, 75}})));
  EXPECT_FALSE(orderViolations(reordered(state, {{75, 25}, {25, 75}, {25, 25}, {75, 75}})).empty());
  EXPECT_FALSE(orderViolations(reordered(state, {{25, 25}, {75, 25}, {25, 75}, {75, 75}})).empty());
}

TEST(OrderCheck, FindsAPlaneThatIsInTwoSets) {
  FoldedState state = run("square 100; fold A valley 50,0 50,100 left");
  const LayerSet set = state.layers.sets().front();
  state.layers = LayerOrder(
      {LayerSet{set.normal, {set.upward[0]}, {}}, LayerSet{set.normal, {set.upward[1]}, {}}});
  EXPECT_TRUE(mentions(orderViolations(state), "layer-sets"));
}

TEST(OrderCheck, FindsAFacetThatIsOffItsPlane) {
  FoldedState state = run("square 100; fold A valley 90 50,0 50,100 left");
  EXPECT_TRUE(isSound(state));
  const Vec3 up{0, 0, 1};
  state.layers = LayerOrder({LayerSet{up, {FacetId(std::size_t{0}), FacetId(std::size_t{1})}, {}}});
  EXPECT_TRUE(mentions(orderViolations(state), "tilted"));
}

TEST(PoseCheck, FindsAnAngleThatIsNotTheHinges) {
  FoldedState state = run("square 100; fold A valley 90 50,0 50,100 left");
  for (Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) edge.angle = -90;
  }
  EXPECT_FALSE(poseViolations(state).empty());
}

TEST(PoseCheck, FindsStretchedPaper) {
  FoldedState state = run("square 100; fold A valley 50,0 50,100 left");
  state.poses[1].origin.x += 1e-5;
  EXPECT_FALSE(poseViolations(state).empty());
}

TEST(PatternCheck, FindsEdgesThatDoNotAgreeWithTheirFacets) {
  FoldedState state = run("square 100; edge 50,0 50,100");
  CreasePattern pattern = state.pattern;
  std::swap(pattern.edges.back().left, pattern.edges.back().right);
  EXPECT_FALSE(patternViolations(pattern).empty());
  pattern = state.pattern;
  pattern.vertices[2] = pattern.vertices[3];
  EXPECT_FALSE(patternViolations(pattern).empty());
}

TEST(StateText, TellsStatesApartByOneBit) {
  const FoldedState a = run("square 100; fold A valley 20,0 80,100 left");
  FoldedState b = a;
  EXPECT_TRUE(isSameState(a, b));
  b.pattern.vertices[0].x = 5e-324;
  EXPECT_FALSE(isSameState(a, b));
}

TEST(ModelText, ReadsWhatItWrites) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    Model model = randomSheet(random);
    const FoldedState state =
        run("square 100; fold A valley 30,0 30,100 left; fold B valley 80,0 80,100 right");
    for (int i = 0; i < 5; ++i) model.steps.push_back(randomStep(random, state, {}));
    EXPECT_EQ(textOf(modelOf(std::string_view(textOf(model)))), textOf(model));
  }
}

TEST(ModelText, RefusesWordsItDoesNotKnow) {
  EXPECT_THROW(modelOf("square 100; crumple"), std::invalid_argument);
  EXPECT_THROW(modelOf("square 100; fold valley 1,1 2,2 upwards"), std::invalid_argument);
  EXPECT_THROW(modelOf(""), std::invalid_argument);
}

TEST(SplinePieces, MeetSmoothly) {
  const std::vector<Piece> pieces =
      splinePieces({{0, 0}, {1, 2}, {3, 3}, {5, 1}, {6, 4}, {9, 0}}, true);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces.front().p[0], (Vec2{0, 0}));
  EXPECT_EQ(pieces.back().p[3], (Vec2{9, 0}));
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    EXPECT_LT(distance(pieces[i].p[3], pieces[i + 1].p[0]), 1e-12);
    EXPECT_LT(distance(pieces[i].p[3] - pieces[i].p[2], pieces[i + 1].p[1] - pieces[i + 1].p[0]),
              1e-12);
  }
}

}  // namespace
}  // namespace kiri::test
