// Counting and choosing layer orders: known numbers of maps, and all choices tried.
// SPDX-License-Identifier: MIT
#include "core/flatfold/layer_states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/core/flatfold/made_problems.h"

namespace kiri {
namespace {

using test::allStates;
using test::mapProblem;
using test::randomProblem;

LayerStates statesOf(OrderProblem problem) {
  Result<LayerStates> states = LayerStates::find(std::move(problem));
  EXPECT_TRUE(states.isOk());
  return std::move(*states);
}

StateCount countOf(OrderProblem problem) {
  LayerStates states = statesOf(std::move(problem));
  EXPECT_TRUE(states.count().isOk());
  return states.total();
}

std::uint32_t maskOf(const LayerValues& values) {
  std::uint32_t mask = 0;
  for (std::size_t p = 0; p < values.size(); ++p) mask |= (values[p] ? 1U : 0U) << p;
  return mask;
}

TEST(LayerStates, StripsOfStampsHaveTheKnownNumbers) {
  const std::vector<int> known{1, 2, 6, 16, 50, 144, 462, 1392};  // OEIS A000136
  for (std::size_t k = 1; k <= known.size(); ++k) {
    EXPECT_EQ(countOf(mapProblem(1, k)), known[k - 1]) << k;
  }
}

TEST(LayerStates, MapsHaveTheKnownNumbers) {
  const std::vector<int> doubled{8, 60, 320, 1980};  // OEIS A001415 (halved there)
  for (std::size_t k = 2; k <= 5; ++k) EXPECT_EQ(countOf(mapProblem(2, k)), doubled[k - 2]) << k;
  EXPECT_EQ(countOf(mapProblem(3, 3)), 1368);
  EXPECT_EQ(countOf(mapProblem(3, 4)), 15552);
}

TEST(LayerStates, A4x4MapHas300608) { EXPECT_EQ(countOf(mapProblem(4, 4)), 300608); }

/// All that may be said of one problem whose states are known.
void expectStates(const OrderProblem& problem, const std::vector<std::uint32_t>& all,
                  bool isEveryOneListed) {
  LayerStates states = statesOf(problem);
  ASSERT_EQ(states.exist(), !all.empty());
  if (!states.exist()) return;
  EXPECT_FALSE(brokenRule(problem, states.first()).has_value());
  ASSERT_TRUE(states.count().isOk());
  ASSERT_EQ(states.total(), all.size());
  const Result<LayerValues> zero = states.state(0);
  ASSERT_TRUE(zero.isOk());
  EXPECT_EQ(*zero, states.first());
  EXPECT_FALSE(states.state(all.size()).isOk());
  if (!isEveryOneListed) return;
  std::set<std::uint32_t> seen;
  for (std::size_t n = 0; n < all.size(); ++n) seen.insert(maskOf(*states.state(n)));
  EXPECT_TRUE(std::equal(seen.begin(), seen.end(), all.begin(), all.end()));
}

TEST(LayerStates, AgreeWithTryingEverythingOnTenThousandProblems) {
  std::mt19937 random(20250805);
  int withStates = 0;
  int without = 0;
  for (std::size_t round = 0; round < 10000; ++round) {
    const OrderProblem problem = randomProblem(random, 2 + round % 7, 12);
    if (problem.pairs.empty()) continue;
    const std::vector<std::uint32_t> all = allStates(problem);
    (all.empty() ? without : withStates)++;
    expectStates(problem, all, all.size() <= 200);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(withStates, 2000);
  EXPECT_GT(without, 500);
}

}  // namespace
}  // namespace kiri
