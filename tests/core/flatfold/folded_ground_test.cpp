// The folded ground: which facets overlap, and what ties their orders.
// SPDX-License-Identifier: MIT
#include "core/flatfold/folded_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/core/flatfold/flat_patterns.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

OrderProblem problemOf(const AssignedPattern& creases) {
  const Result<FlatMap> map = flatMapOf(creases);
  EXPECT_TRUE(map.isOk());
  Result<GroundAndOrders> ground = overlapsOf(creases, *map);
  EXPECT_TRUE(ground.isOk());
  return std::move(ground->problem);
}

TEST(FoldedGround, AMapIsOneStack) {
  for (int columns = 2; columns <= 6; ++columns) {
    for (int rows = 1; rows <= 4; ++rows) {
      const auto facets = static_cast<std::size_t>(columns * rows);
      const OrderProblem problem = problemOf(test::mapPattern(columns, rows));
      EXPECT_EQ(problem.stacks.size(), 1U);
      EXPECT_EQ(problem.pairs.size(), facets * (facets - 1) / 2);
      EXPECT_TRUE(problem.same.empty());
    }
  }
}

/// In a strip of k squares the folds of one side lie on each other: k - 1 of them, by turns left
/// and right.
TEST(FoldedGround, AStripInterleavesTheFoldsOfEachSide) {
  const OrderProblem problem = problemOf(test::mapPattern(7, 1));
  EXPECT_EQ(problem.interleavings.size(), 3U + 3U);
}

TEST(FoldedGround, FlapsOfThePlusOverlapAtTheCornersOnly) {
  const OrderProblem small = problemOf(test::plusPattern(0.5));
  EXPECT_EQ(small.pairs.size(), 8U);
  EXPECT_EQ(small.stacks.size(), 4U);
  // Flaps that reach beyond the middle overlap the one that comes from the other side.
  const OrderProblem large = problemOf(test::plusPattern(1.2));
  EXPECT_EQ(large.pairs.size(), 10U);
}

/// Where the corners of a convex facet lie, and the widest gap between two of them along the
/// normals of their sides: below zero when they overlap.
std::vector<Vec2> foldedCorners(const AssignedPattern& creases, const FlatMap& map, std::size_t f) {
  std::vector<Vec2> corners;
  for (const EdgeUse use : creases.pattern.facets[f].border)
    corners.push_back(map.poses[f].apply(creases.pattern[startOf(creases.pattern, use)]));
  return corners;
}

double gapAlongSides(const std::vector<Vec2>& sides, const std::vector<Vec2>& other) {
  double widest = -1e9;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vec2 axis = normalized(perpendicular(sides[(i + 1) % sides.size()] - sides[i]));
    double low[2] = {1e9, 1e9};
    double high[2] = {-1e9, -1e9};
    for (const Vec2 p : sides) {
      low[0] = std::min(low[0], dot(axis, p));
      high[0] = std::max(high[0], dot(axis, p));
    }
    for (const Vec2 p : other) {
      low[1] = std::min(low[1], dot(axis, p));
      high[1] = std::max(high[1], dot(axis, p));
    }
    widest = std::max({widest, low[1] - high[0], low[0] - high[1]});
  }
  return widest;
}

/// Requires convex facets.
std::vector<FacetPair> overlapsByHand(const AssignedPattern& creases) {
  const Result<FlatMap> map = flatMapOf(creases);
  std::vector<FacetPair> pairs;
  for (std::size_t a = 0; a < creases.pattern.facets.size(); ++a) {
    for (std::size_t b = a + 1; b < creases.pattern.facets.size(); ++b) {
      const std::vector<Vec2> p = foldedCorners(creases, *map, a);
      const std::vector<Vec2> q = foldedCorners(creases, *map, b);
      if (std::max(gapAlongSides(p, q), gapAlongSides(q, p)) < -1e-6)
        pairs.push_back({FacetId(a), FacetId(b)});
    }
  }
  return pairs;
}

TEST(FoldedGround, PairsAreTheFacetsThatOverlap) {
  for (const AssignedPattern& creases : {test::squareTwist(), test::plusPattern(0.9),
                                         test::plusPattern(1.2), test::mapPattern(3, 3)})
    EXPECT_EQ(problemOf(creases).pairs, overlapsByHand(creases));
}

/// Moves every vertex that is not on the rim by up to `part` of the sheet along each axis.
AssignedPattern shaken(AssignedPattern creases, double part, std::uint64_t seed) {
  test::Random random(seed);
  const double by = part * creases.pattern.tolerance.sheetSize();
  for (Vec2& v : creases.pattern.vertices)
    v = v + Vec2{random.between(-by, by), random.between(-by, by)};
  return creases;
}

TEST(FoldedGround, ImpreciseDrawingsHaveTheSameRules) {
  for (const AssignedPattern& creases :
       {test::squareTwist(), test::plusPattern(0.9), test::mapPattern(4, 4), test::mapPattern(7, 1),
        test::twistTessellation(3)}) {
    const OrderProblem exact = problemOf(creases);
    for (const double part : {1e-7, 1e-6, 1e-5, 5e-5}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE(std::to_string(creases.pattern.facets.size()) + " facets, " +
                     std::to_string(part) + ", seed " + std::to_string(seed));
        const OrderProblem drawn = problemOf(shaken(creases, part, seed));
        EXPECT_EQ(drawn.pairs, exact.pairs);
        EXPECT_EQ(drawn.stacks.size(), exact.stacks.size());
        EXPECT_EQ(drawn.same.size(), exact.same.size());
        EXPECT_EQ(drawn.interleavings.size(), exact.interleavings.size());
      }
    }
  }
}

/// The area of the cells, each as often as facets lie on it.
double layeredArea(const FoldedGround& ground) {
  double sum = 0;
  for (const GroundCell& cell : ground.cells) {
    double twice = 0;
    for (std::size_t i = 0; i < cell.corners.size(); ++i)
      twice += cross(ground.points[cell.corners[i]],
                     ground.points[cell.corners[(i + 1) % cell.corners.size()]]);
    sum += twice / 2 * static_cast<double>(cell.facets.size());
  }
  return sum;
}

FoldedGround groundOfPattern(const AssignedPattern& creases) {
  const Result<FlatMap> map = flatMapOf(creases);
  EXPECT_TRUE(map.isOk());
  Result<GroundAndOrders> ground = overlapsOf(creases, *map);
  EXPECT_TRUE(ground.isOk());
  return std::move(ground->ground);
}

TEST(FoldedGround, LayersOfAllCellsAreThePaper) {
  for (const AssignedPattern& creases :
       {test::squareTwist(), test::plusPattern(1.2), test::mapPattern(5, 3),
        test::twistTessellation(4), test::windowPattern()})
    EXPECT_NEAR(layeredArea(groundOfPattern(creases)), areaOf(creases.pattern),
                1e-9 * areaOf(creases.pattern));
}

/// A frame around a hole, folded along one line: the ground is a band with a hole in it, and a cell
/// with a hole in it where a facet lies alone around it.
TEST(FoldedGround, CellsMayHaveHoles) {
  const AssignedPattern window = test::windowPattern();
  const FoldedGround ground = groundOfPattern(window);
  const OrderProblem problem = problemOf(window);
  ASSERT_EQ(problem.facetCount, 2U);
  EXPECT_EQ(problem.pairs.size(), 1U);
  EXPECT_EQ(ground.cells.size(), 2U);
}

/// Two pieces of paper that lie on each other at rest do not exist; side by side they never meet.
TEST(FoldedGround, PiecesLieApart) {
  const std::vector<test::DrawnEdge> edges{
      {0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2, EdgeKind::Hinge, 180}, {1, 4}, {4, 5}, {5, 2}};
  std::vector<test::DrawnEdge> cut = edges;
  cut[1].kind = EdgeKind::Cut;
  const std::vector<Vec2> vertices{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {3, 0}, {3, 1}};
  const OrderProblem problem = problemOf(test::unassignedPattern(vertices, cut));
  EXPECT_EQ(problem.facetCount, 3U);
  EXPECT_EQ(problem.pairs.size(), 1U);
}

/// A cross of creases with a slit along half of one of them: the slit ties nothing, and lets two
/// quarters part that would otherwise fold together.
TEST(FoldedGround, SlitsTieNothing) {
  const OrderProblem whole = problemOf(test::mapPattern(2, 2));
  AssignedPattern creases = test::mapPattern(2, 2);
  EXPECT_EQ(whole.interleavings.size(), 2U);
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    Edge& edge = creases.pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge) continue;
    edge.kind = EdgeKind::Cut;
    creases.assignments[e] = Assignment::Cut;
    break;
  }
  const OrderProblem slit = problemOf(creases);
  EXPECT_EQ(slit.pairs, whole.pairs);
  EXPECT_EQ(slit.interleavings.size(), 1U);
}

TEST(FoldedGround, StopsWhenNobodyWantsItAnyMore) {
  const AssignedPattern creases = test::twistTessellation(6);
  const Result<FlatMap> map = flatMapOf(creases);
  ASSERT_TRUE(map.isOk());
  double last = -1;
  ASSERT_TRUE(overlapsOf(creases, *map, [&](double part) {
                EXPECT_GE(part, last);
                EXPECT_LE(part, 1);
                last = part;
                return true;
              }).isOk());
  EXPECT_GT(last, 0.5);
  for (const double until : {0.0, 0.2, 0.6}) {
    const Result<GroundAndOrders> stopped =
        overlapsOf(creases, *map, [&](double part) { return part < until; });
    ASSERT_FALSE(stopped.isOk());
    EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  }
}

}  // namespace
}  // namespace kiri
