// Poses, pieces and amounts of a state; and the relation that a layer order tells.
// SPDX-License-Identifier: MIT
#include "core/paper/folded_state.h"

#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

TEST(FlatState, LiesInThePaperFrameWithItsFrontUp) {
  const FoldedState state = run("rectangle 80 40");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(isFlat(state));
  EXPECT_EQ(state.poses.front(), Rigid{});
  EXPECT_EQ(stretchOf(state), 0);
  EXPECT_EQ(state.layers.sets().size(), 1u);
}

TEST(DerivePoses, TurnsTheRightFacetTowardsTheFrontInAValley) {
  FoldedState state = run("square 100; edge 50,0 50,100");
  for (Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) edge.angle = 90;
  }
  const std::vector<Rigid> poses = derivePoses(state.pattern, state.rests);
  const FacetId rest = state.rests.front().facet;
  const FacetId other(1 - rest.index);
  const Vec2 inside = interiorPointOf(state.pattern, other);
  EXPECT_GT(poses[other.index].apply(inside).z, 10);
}

TEST(StretchOf, TellsHowFarTheSidesOfAHingeAreApart) {
  FoldedState state = run("square 100; fold A valley 50,0 50,100 left");
  EXPECT_LT(stretchOf(state), 1e-9);
  state.poses[0].origin.z += 0.25;
  EXPECT_NEAR(stretchOf(state), 0.25, 1e-12);
}

TEST(PiecesOf, AreNumberedByTheirLowestFacet) {
  const FoldedState state = run("square 100; edge 50,0 50,100; edge 25,0 25,100; tear 50,0 50,100");
  const std::vector<std::uint32_t> pieces = piecesOf(state.pattern);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0], 0u);
  EXPECT_EQ(pieces[facetOf(state, {10, 50}).index], pieces[facetOf(state, {40, 50}).index]);
  EXPECT_NE(pieces[facetOf(state, {10, 50}).index], pieces[facetOf(state, {80, 50}).index]);
  EXPECT_EQ(pieceCount(state), 2u);
  EXPECT_EQ(state.rests.size(), 2u);
}

TEST(AmountOf, IsNoneWhenTheHingesDisagree) {
  FoldedState state = run("square 100; edge 0,50 100,50; fold A valley 50,0 50,100 left");
  EXPECT_DOUBLE_EQ(kiri::amountOf(state, FoldLineId(std::size_t{0})).value(), 180);
  for (Edge& edge : state.pattern.edges) {
    if (!edge.line.isValid()) continue;
    edge.angle = 20;
    break;
  }
  EXPECT_FALSE(kiri::amountOf(state, FoldLineId(std::size_t{0})).has_value());
}

TEST(LayerOrder, SaysWhatAListCannot) {
  const FacetId a(std::size_t{0});
  const FacetId b(std::size_t{1});
  const FacetId c(std::size_t{2});
  const LayerOrder circle({LayerSet{{0, 0, 1}, {a, b, c}, {{a, c}}}});
  EXPECT_TRUE(circle.isAbove(b, a));
  EXPECT_TRUE(circle.isAbove(c, b));
  EXPECT_TRUE(circle.isAbove(a, c));
  EXPECT_FALSE(circle.isAbove(c, a));
}

TEST(LayerOrder, KnowsThePlaceOfEveryFacet) {
  const FacetId a(std::size_t{0});
  const FacetId b(std::size_t{1});
  const LayerOrder order({LayerSet{{0, 0, 1}, {b}, {}}, LayerSet{{1, 0, 0}, {a}, {}}});
  EXPECT_EQ(order.setOf(a), 1u);
  EXPECT_EQ(order.rankOf(b), 0u);
  EXPECT_FALSE(order.areCoplanar(a, b));
}

}  // namespace
}  // namespace kiri::test
