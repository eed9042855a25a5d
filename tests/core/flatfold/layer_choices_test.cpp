// Walking, picking, stopping and explaining layer orders.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/flatfold/flat_folding.h"
#include "core/flatfold/order_conflict.h"
#include "tests/core/flatfold/flat_patterns.h"
#include "tests/core/flatfold/made_problems.h"
#include "tests/core/flatfold/sampled_check.h"

namespace kiri::test {
namespace {

LayerStates solved(const OrderProblem& problem) {
  Result<LayerStates> states = LayerStates::find(problem);
  EXPECT_TRUE(states.isOk());
  return std::move(*states);
}

/// Two problems beside each other that have nothing to do with each other.
OrderProblem beside(const OrderProblem& a, const OrderProblem& b) {
  OrderProblem both = a;
  both.facetCount += b.facetCount;
  const auto pairs = static_cast<std::uint32_t>(a.pairs.size());
  const auto moved = [&](Literal l) { return Literal(l.pair() + pairs, l.isNegated()); };
  for (const FacetPair& p : b.pairs) {
    both.pairs.push_back({FacetId(p.a.index + a.facetCount), FacetId(p.b.index + a.facetCount)});
  }
  for (std::size_t s = 0; s < b.stacks.size(); ++s) {
    std::vector<FacetId> stack;
    for (const FacetId* f = b.stacks.begin(s); f != b.stacks.end(s); ++f) {
      stack.push_back(FacetId(f->index + a.facetCount));
    }
    both.stacks.add(stack);
  }
  for (const SameOrder& s : b.same) both.same.push_back({moved(s.first), moved(s.second)});
  for (const Interleaving& i : b.interleavings) {
    both.interleavings.push_back({moved(i.ac), moved(i.bc), moved(i.ad), moved(i.bd)});
  }
  for (const Literal l : b.known) both.known.push_back(moved(l));
  return both;
}

TEST(LayerChoices, ComponentsAreChosenWhateverTheOthersAre) {
  const OrderProblem problem = beside(mapProblem(1, 4), mapProblem(2, 2));
  LayerStates states = solved(problem);
  ASSERT_EQ(states.componentCount(), 2U);
  ASSERT_TRUE(states.count().isOk());
  EXPECT_EQ(states.total(), 16 * 8);
  std::set<LayerValues> seen;
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < 8; ++j) {
      LayerValues values = states.first();
      ASSERT_TRUE(states.choose(0, i, values).isOk());
      ASSERT_TRUE(states.choose(1, j, values).isOk());
      EXPECT_FALSE(brokenRule(problem, values).has_value());
      // The first component changes slowest.
      EXPECT_EQ(*states.state(8 * i + j), values);
      seen.insert(values);
    }
  }
  EXPECT_EQ(seen.size(), 128U);
  LayerValues values = states.first();
  const Status tooMany = states.choose(1, 8, values);
  ASSERT_FALSE(tooMany.isOk());
  EXPECT_EQ(tooMany.error().code, ErrorCode::NotFound);
  EXPECT_NE(tooMany.error().message.find("only 8 states"), std::string::npos);
}

/// In a component every order takes both values; all others are the same in every state.
TEST(LayerChoices, ComponentsHoldExactlyTheOrdersThatVary) {
  std::mt19937 random(77);
  for (std::size_t round = 0; round < 2000; ++round) {
    const OrderProblem problem = randomProblem(random, 2 + round % 7, 12);
    const std::vector<std::uint32_t> all = allStates(problem);
    if (all.empty() || problem.pairs.empty()) continue;
    std::uint32_t some = 0;
    std::uint32_t every = ~0U;
    for (const std::uint32_t mask : all) {
      some |= mask;
      every &= mask;
    }
    std::uint32_t inComponents = 0;
    const LayerStates states = solved(problem);
    for (std::size_t c = 0; c < states.componentCount(); ++c) {
      for (const std::uint32_t pair : states.component(c).pairs) {
        EXPECT_EQ(inComponents >> pair & 1, 0U);
        inComponents |= 1U << pair;
      }
    }
    ASSERT_EQ(inComponents, some & ~every) << "round " << round;
  }
}

/// Six by six squares have more orders than any program counts; the first few are walked all
/// the same, and one is found in which given facets lie as wanted.
TEST(LayerChoices, StatesAreWalkedWithoutCounting) {
  const OrderProblem problem = mapProblem(6, 6);
  const LayerStates states = solved(problem);
  std::set<LayerValues> seen;
  for (int n = 0; n < 5; ++n) {
    const Result<LayerValues> values = states.state(n);
    ASSERT_TRUE(values.isOk()) << values.error().message;
    EXPECT_FALSE(brokenRule(problem, *values).has_value());
    seen.insert(*values);
  }
  EXPECT_EQ(seen.size(), 5U);
  const Literal turned(7, states.first()[7]);
  const Result<LayerValues> picked = states.stateWith({turned}, states.first());
  ASSERT_TRUE(picked.isOk());
  EXPECT_NE((*picked)[7], states.first()[7]);
  EXPECT_FALSE(brokenRule(problem, *picked).has_value());
}

TEST(LayerChoices, AWantedStateIsFoundExactlyWhereThereIsOne) {
  std::mt19937 random(99);
  for (std::size_t round = 0; round < 1000; ++round) {
    const OrderProblem problem = randomProblem(random, 2 + round % 7, 10);
    const std::vector<std::uint32_t> all = allStates(problem);
    if (all.empty() || problem.pairs.size() < 2) continue;
    const LayerStates states = solved(problem);
    const auto literal = [&] {
      return Literal(static_cast<std::uint32_t>(random() % problem.pairs.size()),
                     random() % 2 == 0);
    };
    const std::vector<Literal> wanted{literal(), literal()};
    const auto holds = [](std::uint32_t mask, Literal l) {
      return (mask >> l.pair() & 1) != (l.isNegated() ? 1U : 0U);
    };
    const bool isThere = std::any_of(all.begin(), all.end(), [&](std::uint32_t mask) {
      return holds(mask, wanted[0]) && holds(mask, wanted[1]);
    });
    const Result<LayerValues> found = states.stateWith(wanted, states.first());
    ASSERT_EQ(found.isOk(), isThere) << "round " << round;
    if (!isThere) continue;
    EXPECT_FALSE(brokenRule(problem, *found).has_value());
    for (const Literal l : wanted) EXPECT_NE((*found)[l.pair()], l.isNegated());
  }
}

/// The facets of a conflict have no order; without any one of them the others have.
TEST(OrderConflict, NamesFacetsOfWhichNoneCanBeLeftOut) {
  std::mt19937 random(5);
  const Progress progress;
  WorkMeter meter(progress, std::size_t{1} << 30);
  std::size_t conflicts = 0;
  for (std::size_t round = 0; round < 3000; ++round) {
    const OrderProblem problem = randomProblem(random, 4 + round % 5, 12);
    const LayerStates states = solved(problem);
    if (states.exist()) continue;
    ++conflicts;
    const std::vector<FacetId> facets = states.conflict().facets;
    EXPECT_TRUE(allStates(restrictedTo(problem, facets)).empty()) << "round " << round;
    for (std::size_t i = 0; i < facets.size(); ++i) {
      std::vector<FacetId> fewer = facets;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_FALSE(allStates(restrictedTo(problem, fewer)).empty()) << "round " << round;
    }
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(conflicts, 200U);
}

TEST(LayerChoices, LongWorkStopsWhenNobodyWantsIt) {
  LayerStates states = solved(mapProblem(5, 5));
  int asked = 0;
  const Status counted = states.count([&](double) { return ++asked < 5; });
  ASSERT_FALSE(counted.isOk());
  EXPECT_EQ(counted.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(asked, 5);
  const Result<LayerStates> found =
      LayerStates::find(mapProblem(10, 10), {}, [](double) { return false; });
  ASSERT_FALSE(found.isOk());
  EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
}

TEST(LayerChoices, TooLittleMemoryIsTold) {
  const Result<LayerStates> found = LayerStates::find(mapProblem(10, 10), {std::size_t{1} << 20});
  ASSERT_FALSE(found.isOk());
  EXPECT_EQ(found.error().code, ErrorCode::BadValue);
  EXPECT_NE(found.error().message.find("1 MB"), std::string::npos);
  // Counting does with what there is: it forgets.
  Result<LayerStates> small = LayerStates::find(mapProblem(3, 4), {std::size_t{1} << 18});
  ASSERT_TRUE(small.isOk());
  ASSERT_TRUE(small->count().isOk());
  EXPECT_EQ(small->total(), 15552);
}

TEST(SampledCheck, SeesLayersThatWereMixedUp) {
  const Result<FlatFolding> folding = flatFold(mapPattern(4, 3));
  ASSERT_TRUE(folding.isOk());
  FoldedState state =
      foldedStateOf(folding->creases, folding->states.problem(), folding->states.first());
  const SampledCheck right = sampledCheck(state, 3, 1e-4);
  EXPECT_TRUE(right.violations.empty());
  EXPECT_GT(right.places, 40U);
  LayerSet set = state.layers.sets().front();
  std::swap(set.upward[2], set.upward[7]);
  state.layers = LayerOrder({set});
  EXPECT_FALSE(sampledCheck(state, 3, 1e-4).violations.empty());
}

}  // namespace
}  // namespace kiri::test
