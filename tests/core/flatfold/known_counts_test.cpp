// Patterns whose numbers of layer orders are known, drawn by hand, and their states in the kernel.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/flatfold/flat_folding.h"
#include "tests/core/flatfold/flat_patterns.h"
#include "tests/support/order_check.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// A star of equal sectors, all creases folded, no direction given.
AssignedPattern equalStar(std::size_t degree) {
  AssignedPattern creases(
      starOf(std::vector<double>(degree, 2 * std::numbers::pi / static_cast<double>(degree)))
          .pattern);
  for (Edge& edge : creases.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) edge.angle = 180;
    creases.assignments.push_back(edge.kind == EdgeKind::Hinge ? Assignment::Unassigned
                                                               : Assignment::Border);
  }
  return creases;
}

AssignedPattern squareWith(std::vector<Vec2> more, const std::vector<DrawnEdge>& creases,
                           const std::vector<std::size_t>& rim) {
  std::vector<Vec2> vertices{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  vertices.insert(vertices.end(), more.begin(), more.end());
  std::vector<DrawnEdge> edges = creases;
  for (std::size_t i = 0; i < rim.size(); ++i) edges.push_back({rim[i], rim[(i + 1) % rim.size()]});
  return unassignedPattern(vertices, edges);
}

DrawnEdge folded(std::size_t from, std::size_t to) { return {from, to, EdgeKind::Hinge, 180}; }

AssignedPattern kiteBase() {
  const double reach = 2 * std::tan(std::numbers::pi / 8) - 1;
  return squareWith({{1, reach}, {reach, 1}}, {folded(0, 4), folded(0, 5)}, {0, 1, 4, 2, 5, 3});
}

AssignedPattern blintz() {
  return squareWith({{0, -1}, {1, 0}, {0, 1}, {-1, 0}},
                    {folded(4, 5), folded(5, 6), folded(6, 7), folded(7, 4)},
                    {0, 4, 1, 5, 2, 6, 3, 7});
}

AssignedPattern waterbomb() {
  return squareWith(
      {{0, 0}, {1, 0}, {-1, 0}},
      {folded(4, 0), folded(4, 1), folded(4, 2), folded(4, 3), folded(4, 5), folded(4, 6)},
      {0, 1, 5, 2, 3, 6});
}

/// Counts the orders of a pattern; every one of them must satisfy the independent judge.
StateCount countOf(const AssignedPattern& creases) {
  Result<FlatFolding> folding = flatFold(creases);
  if (!folding.isOk()) {
    ADD_FAILURE() << folding.error().message;
    return 0;
  }
  LayerStates& states = folding->states;
  EXPECT_TRUE(states.count().isOk());
  for (StateCount n = 0; n < states.total(); n += 1 + states.total() / 50) {
    const Result<LayerValues> values = states.state(n);
    if (!values.isOk()) {
      ADD_FAILURE() << values.error().message;
      break;
    }
    const FoldedState state = foldedStateOf(folding->creases, states.problem(), *values);
    EXPECT_LE(stretchOf(state), state.tolerance().length());
    EXPECT_EQ(joined(orderViolations(state)), "") << "state " << n;
  }
  return states.total();
}

TEST(KnownCounts, StarsOfEqualSectors) {
  EXPECT_EQ(countOf(equalStar(4)), 8);
  EXPECT_EQ(countOf(equalStar(6)), 48);
  EXPECT_EQ(countOf(equalStar(8)), 336);
}

/// The plus-sheet with its four flaps on top.
AssignedPattern closedPlus(double length) {
  AssignedPattern creases = plusPattern(length);
  for (std::size_t e = 0; e < 4; ++e) assign(creases, EdgeId(e), Assignment::Valley);
  return creases;
}

TEST(KnownCounts, PlusSheetsWithShortAndLongFlaps) {
  EXPECT_EQ(countOf(closedPlus(0.5)), 16);
  EXPECT_EQ(countOf(closedPlus(1)), 16);
  EXPECT_EQ(countOf(closedPlus(1.2)), 24);
  EXPECT_EQ(countOf(closedPlus(2)), 24);
  // Flaps of one side are free at their corner, others are not: the trace of [[2, 1], [1, 2]]^4.
  EXPECT_EQ(countOf(plusPattern(1)), 82);
  EXPECT_EQ(countOf(plusPattern(1.2)), 120);
}

TEST(KnownCounts, SquareTwist) { EXPECT_EQ(countOf(squareTwist()), 16); }

TEST(KnownCounts, Bases) {
  EXPECT_EQ(countOf(kiteBase()), 4);
  EXPECT_EQ(countOf(blintz()), 16);
  EXPECT_EQ(countOf(waterbomb()), 18);
}

TEST(KnownCounts, Maps) {
  EXPECT_EQ(countOf(mapPattern(2, 2)), 8);
  EXPECT_EQ(countOf(mapPattern(5, 1)), 50);
  EXPECT_EQ(countOf(mapPattern(3, 3)), 1368);
}

/// Two of the 16 orders of the plus-sheet go round in a ring that no list can say.
TEST(FoldedStateOf, RingsAreExceptions) {
  Result<FlatFolding> folding = flatFold(closedPlus(1));
  ASSERT_TRUE(folding.isOk());
  int rings = 0;
  for (int n = 0; n < 16; ++n) {
    const Result<LayerValues> values = folding->states.state(n);
    ASSERT_TRUE(values.isOk());
    const LayerOrder order = layerOrderOf(folding->states.problem(), *values);
    ASSERT_EQ(order.sets().size(), 1U);
    if (!order.sets()[0].exceptions.empty()) ++rings;
    for (std::size_t p = 0; p < values->size(); ++p) {
      const FacetPair& pair = folding->states.problem().pairs[p];
      EXPECT_EQ(order.isAbove(pair.a, pair.b), (*values)[p]);
    }
  }
  EXPECT_EQ(rings, 2);
}

}  // namespace
}  // namespace kiri::test
