// Which closed loops a crease pattern has, and when they close.
// SPDX-License-Identifier: MIT
#include "core/linkage/loops.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/linkage/closure.h"
#include "core/linkage/rigid_path.h"
#include "tests/support/pattern_text.h"

namespace kiri::test {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

std::vector<EdgeId> hingesOf(const FoldedState& state) {
  std::vector<EdgeId> hinges;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (state.pattern.edges[e].kind == EdgeKind::Hinge) hinges.push_back(EdgeId(e));
  }
  return hinges;
}

Closure closureOf(const FoldedState& state) {
  return {state.pattern, hingesOf(state), hingesOf(state)};
}

/// A square frame of four facets, its creases from corners of the rim to those of the hole.
/// `inner` are the corners of the hole.
FoldedState frameOf(const std::vector<Vec2>& inner) {
  std::vector<Vec2> vertices{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  vertices.insert(vertices.end(), inner.begin(), inner.end());
  std::vector<DrawnEdge> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    edges.push_back({i, i + 4});
    edges.push_back({i, (i + 1) % 4});
    edges.push_back({i + 4, (i + 1) % 4 + 4});
  }
  return drawnState(vertices, edges, {{0, 0}});
}

TEST(LoopsOf, AnOpenFanHasNone) { EXPECT_TRUE(loopsOf(starOf({1, 1, 1, 1}).pattern).empty()); }

TEST(LoopsOf, AVertexInsideThePaperIsOne) {
  const std::vector<HingeLoop> loops = loopsOf(starOf({1, 1.3, 2, 2 * kQuarter * 2 - 4.3}).pattern);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_TRUE(loops[0].isVertex);
  EXPECT_EQ(loops[0].centre, (Vec2{0, 0}));
  EXPECT_EQ(loops[0].crossings.size(), 4u);
}

TEST(LoopsOf, ACorrugationHasOneForEachVertexInside) {
  EXPECT_EQ(loopsOf(corrugationOf(5, 4, 60).state.pattern).size(), 12u);
}

TEST(LoopsOf, AHoleIsOneThatIsNoVertex) {
  const std::vector<HingeLoop> loops =
      loopsOf(frameOf({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}).pattern);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_FALSE(loops[0].isVertex);
  EXPECT_EQ(loops[0].crossings.size(), 4u);
}

TEST(LoopsOf, ATearToTheRimOpensTheLoopAndASlitInsideJoinsTwo) {
  // Two vertices inside, joined by an edge; three creases from each to the rim.
  const std::vector<Vec2> vertices{{-20, 0}, {20, 0}, {-50, 0},  {-20, 50},
                                   {20, 50}, {50, 0}, {20, -50}, {-20, -50}};
  std::vector<DrawnEdge> edges{{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}, {1, 6}, {0, 7}};
  for (std::size_t i = 2; i < 8; ++i) edges.push_back({i, i == 7 ? 2 : i + 1});
  EXPECT_EQ(loopsOf(drawnState(vertices, edges).pattern).size(), 2u);
  edges[0].kind = EdgeKind::Tear;
  const std::vector<HingeLoop> joined = loopsOf(drawnState(vertices, edges).pattern);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_FALSE(joined[0].isVertex);
  EXPECT_EQ(joined[0].crossings.size(), 6u);
  edges[1].kind = EdgeKind::Tear;
  EXPECT_TRUE(loopsOf(drawnState(vertices, edges).pattern).empty());
}

// Guide to algorithms 1.7: line 1 at any angle with line 2 flat closes, line 1 folded with line 2
// at any angle closes, both half folded miss by 1.
TEST(Closure, TheCrossPatternClosesOneLineAtATime) {
  const FoldedState cross = starOf({kQuarter, kQuarter, kQuarter, kQuarter});
  const Closure closure = closureOf(cross);
  const auto error = [&](double line1, double line2, double sign) {
    FoldAngles angles(cross.pattern.edges.size(), 0);
    angles[0] = angles[2] = line1;
    angles[1] = line2;
    angles[3] = sign * line2;
    return closure.error(angles);
  };
  for (const double angle : {-180., -77., 3., 45., 90., 123.4, 180.}) {
    EXPECT_LT(error(angle, 0, 1), 1e-15);
    EXPECT_LT(error(180, angle, -1), 1e-15);
  }
  EXPECT_NEAR(error(90, 90, 1), 1.0, 1e-15);
  EXPECT_NEAR(error(90, 90, -1), 1.0, 1e-15);
}

TEST(Closure, AgreesWithTheGapOfPosesWhereAHoleDoesNotClose) {
  const FoldedState frame = frameOf({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
  FoldAngles angles(frame.pattern.edges.size(), 0);
  angles[0] = angles[6] = 40;  // the creases of one diagonal
  EXPECT_LT(closureOf(frame).error(angles), 1e-15);
  EXPECT_LT(closureError(frame.pattern, frame.rests, angles), 1e-12);
  angles[6] = 41;
  EXPECT_GT(closureOf(frame).error(angles), 1e-3);
  EXPECT_GT(closureError(frame.pattern, frame.rests, angles), 0.1);
}

TEST(Closure, CreasesThatDoNotMeetInOnePointHoldAFrameFast) {
  const FoldedState frame = frameOf({{-10, -30}, {30, -10}, {10, 30}, {-30, 10}});
  PathRequest request;
  request.wanted.assign(frame.pattern.edges.size(), 0);
  for (const EdgeId e : hingesOf(frame)) request.wanted[e.index] = 60;
  request.driven = {hingesOf(frame)[0]};
  request.free = {hingesOf(frame)[1], hingesOf(frame)[2], hingesOf(frame)[3]};
  const RigidPath path = rigidPath(frame, request);
  EXPECT_EQ(path.reach(), 0);
  EXPECT_EQ(path.stop().end, PathEnd::Locked);
  EXPECT_EQ(path.stop().hinges, hingesOf(frame));
}

}  // namespace
}  // namespace kiri::test
