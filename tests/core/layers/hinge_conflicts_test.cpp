// Paper along hinges: states that are right have no conflicts; spoiled ones have.
// SPDX-License-Identifier: MIT
#include "core/layers/hinge_conflicts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/order_check.h"

namespace kiri::test {
namespace {

std::size_t conflictsIn(const FoldedState& state) {
  std::size_t count = 0;
  for (std::size_t set = 0; set < state.layers.sets().size(); ++set)
    count += hingeConflicts(state.pattern, state.poses, state.layers, set, {}).size();
  return count;
}

/// The state with the order of one layer-set that has two or more facets rotated by one place.
std::vector<FoldedState> spoiled(const FoldedState& state) {
  std::vector<FoldedState> states;
  for (std::size_t set = 0; set < state.layers.sets().size(); ++set) {
    const std::size_t count = state.layers.sets()[set].upward.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        std::vector<LayerSet> sets = state.layers.sets();
        std::swap(sets[set].upward[i], sets[set].upward[j]);
        FoldedState other = state;
        other.layers = LayerOrder(std::move(sets));
        states.push_back(std::move(other));
      }
    }
  }
  return states;
}

constexpr const char* kModels[] = {
    "rectangle 120 20; fold A valley 40,0 40,20 left; fold B valley @model 80,0 80,20 right",
    "square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left;"
    "fold C valley 90 @model 75,-10 75,110 right",
    "rectangle 200 20; fold H valley 100,0 100,20 right; fold U valley 90 @model 40,-5 40,25 left",
    "rectangle 200 20; fold H valley 100,0 100,20 right;"
    "fold U valley 120 @model 40,-5 40,25 left facets p:170,10;"
    "fold L valley 60 @model 40,-5 40,25 left facets p:20,10",
};

TEST(HingeConflicts, AreNoneInFoldedPaper) {
  for (const char* text : kModels) {
    const FoldedState state = run(text);
    ASSERT_TRUE(isClean(state)) << text;
    EXPECT_EQ(conflictsIn(state), 0u) << text;
  }
}

TEST(HingeConflicts, AreThoseThatTheCheckWrittenApartFinds) {
  // Only what passes at hinges is compared: the sign of a fold is no matter of conflicts.
  int wrong = 0;
  for (const char* text : kModels) {
    for (const FoldedState& state : spoiled(run(text))) {
      const std::vector<std::string> found = orderViolations(state);
      const bool doesPass = std::any_of(found.begin(), found.end(), [](const std::string& s) {
        return s.find("passes through paper at the hinge") != std::string::npos;
      });
      EXPECT_EQ(conflictsIn(state) > 0, doesPass) << text;
      wrong += doesPass ? 1 : 0;
    }
  }
  EXPECT_GT(wrong, 5);
}

TEST(HingeConflicts, StandingLayersKeepTheOrderOfTheLayersTheyHangOn) {
  // Two layers bent up together along one line: swapped in one plane only, they cross.
  const FoldedState state = run(kModels[2]);
  int tied = 0;
  for (const FoldedState& other : spoiled(state)) tied += conflictsIn(other) > 0 ? 1 : 0;
  EXPECT_EQ(tied, 2);
}

}  // namespace
}  // namespace kiri::test
