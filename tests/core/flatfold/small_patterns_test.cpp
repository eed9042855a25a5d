// Small random patterns have exactly the layer orders that trying everything finds.
// SPDX-License-Identifier: MIT
#include "tests/core/flatfold/small_patterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/flatfold/flat_folding.h"
#include "tests/support/sanitized.h"

namespace kiri::test {
namespace {

std::vector<bool> truthsOf(const WholeOrder& order) {
  std::vector<bool> truths;
  for (const OrderedPair& pair : order) truths.push_back(pair.isAbove);
  return truths;
}

/// All states of the solver in the words of the trial, which lists pairs in another order.
std::vector<WholeOrder> ordersBySearching(const LayerStates& states, StateCount total) {
  std::vector<WholeOrder> orders;
  for (StateCount n = 0; n < total; ++n) {
    const LayerValues values = *states.state(n);
    WholeOrder order;
    for (std::size_t p = 0; p < values.size(); ++p) {
      const FacetPair& pair = states.problem().pairs[p];
      order.push_back({pair.a, pair.b, values[p]});
    }
    std::sort(order.begin(), order.end(), [](const OrderedPair& x, const OrderedPair& y) {
      return std::pair(x.b, x.a) < std::pair(y.b, y.a);
    });
    orders.push_back(std::move(order));
  }
  std::sort(orders.begin(), orders.end(),
            [](const WholeOrder& x, const WholeOrder& y) { return truthsOf(x) < truthsOf(y); });
  return orders;
}

struct Tally {
  std::size_t compared = 0;
  std::size_t without = 0;
  std::size_t several = 0;
};

void compare(const AssignedPattern& creases, Tally& tally) {
  constexpr std::size_t kJudged = 200;
  Result<FlatFolding> folding = flatFold(creases);
  if (!folding.isOk()) {
    ASSERT_EQ(folding.error().code, ErrorCode::WouldStretch) << folding.error().message;
    return;
  }
  const auto& poses = folding->map.poses;
  const auto rest = std::find_if(poses.begin(), poses.end(), [](const FlatPose& pose) {
    return pose.x == Vec2{1, 0} && pose.y == Vec2{0, 1} && pose.origin == Vec2{0, 0};
  });
  const auto byTrying =
      ordersByTrying(creases, FacetId(static_cast<std::size_t>(rest - poses.begin())), kJudged);
  if (!byTrying) return;
  ++tally.compared;
  if (byTrying->empty()) ++tally.without;
  if (byTrying->size() > 1) ++tally.several;
  LayerStates& states = folding->states;
  ASSERT_EQ(states.exist(), !byTrying->empty());
  if (!states.exist()) return;
  ASSERT_TRUE(states.count().isOk());
  ASSERT_EQ(states.total(), byTrying->size());
  EXPECT_EQ(ordersBySearching(states, states.total()), *byTrying);
}

/// With KIRI_ALL_PATTERNS in the environment ten thousand patterns, else some hundreds.
TEST(SmallPatterns, HaveTheOrdersThatTryingEverythingFinds) {
  const std::size_t wanted =
      std::getenv("KIRI_ALL_PATTERNS") != nullptr ? 10000 : casesOf<std::size_t>(400, 60);
  Tally tally;
  for (std::uint64_t seed = 1; tally.compared < wanted; ++seed) {
    Random random(seed);
    compare(smallPattern(random), tally);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(tally.without, wanted / 50);
  EXPECT_GT(tally.several, wanted / 10);
}

}  // namespace
}  // namespace kiri::test
