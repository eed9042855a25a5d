// The folded ground: which facets overlap, and what ties their orders.
// SPDX-License-Identifier: MIT
#include "core/flatfold/folded_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/core/flatfold/flat_patterns.h"

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

}  // namespace
}  // namespace kiri
