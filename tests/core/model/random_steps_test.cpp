// Random steps of all kinds: what must hold of every state, whatever was done.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/model/apply.h"
#include "core/model/history.h"
#include "tests/support/crossing_check.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/order_check.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"
#include "tests/support/state_check.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

// A fixed count: the same models on every machine. Sanitizers take ten times as long.
constexpr std::uint64_t kSeeds = casesOf<std::uint64_t>(12, 2);

bool discards(const Step& step) {
  const auto* straight = std::get_if<StraightCutStep>(&step.action);
  const auto* curve = std::get_if<CurveCutStep>(&step.action);
  return (straight != nullptr && !straight->keep.places.empty()) ||
         (curve != nullptr && !curve->keep.places.empty());
}

/// A model grown from random steps that apply; `check` sees every state.
template <class Check>
Model grow(std::uint64_t seed, std::size_t legalSteps, const RandomStepOptions& options,
           Check check) {
  Random random(seed);
  Model model = randomSheet(random);
  FoldedState state = startOf(model);
  for (std::size_t tries = 0; tries < 40 * legalSteps && model.steps.size() < legalSteps; ++tries) {
    const Step step = randomStep(random, state, options);
    const int number = static_cast<int>(model.steps.size()) + 1;
    Result<FoldedState> next = apply(state, step, number);
    if (!next) {
      EXPECT_FALSE(next.error().message.empty());
      continue;
    }
    model.steps.push_back(step);
    if (!check(model, state, *next)) break;
    state = std::move(next).value();
  }
  return model;
}

std::string trace(std::uint64_t seed, const Model& model) {
  return "seed " + std::to_string(seed) + "\n" + textOf(model);
}

class RandomSteps : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomSteps, KeepAreaIsometryAndPattern) {
  const std::uint64_t seed = GetParam();
  const Model grown =
      grow(seed, 200, {},
           [seed](const Model& model, const FoldedState& before, const FoldedState& state) {
             std::vector<std::string> found = patternViolations(state.pattern);
             if (found.empty()) found = poseViolations(state);
             if (!found.empty()) {
               ADD_FAILURE() << trace(seed, model) << joined(found);
               return false;
             }
             const double area = areaOf(before);
             if (discards(model.steps.back())) {
               EXPECT_LE(areaOf(state), area * (1 + 1e-12)) << trace(seed, model);
             } else {
               EXPECT_NEAR(areaOf(state), area, 1e-9 * area) << trace(seed, model);
             }
             return !testing::Test::HasFailure();
           });
  EXPECT_EQ(grown.steps.size(), 200u) << "seed " << seed;
}

TEST_P(RandomSteps, KeepLayersRightWhileNothingCollides) {
  const std::uint64_t seed = GetParam() + 1000;
  RandomStepOptions options;
  options.facetLimit = 24;
  grow(seed, 60, options, [seed](const Model& model, const FoldedState&, const FoldedState& state) {
    if (!state.collisions.empty()) return false;
    std::vector<std::string> found = orderViolations(state);
    for (std::string& sentence : crossingViolations(state)) found.push_back(std::move(sentence));
    if (!found.empty()) ADD_FAILURE() << trace(seed, model) << joined(found);
    return found.empty();
  });
}

TEST_P(RandomSteps, ReplayToTheSameBytes) {
  const std::uint64_t seed = GetParam() + 2000;
  std::vector<std::string> texts;
  const Model model =
      grow(seed, 40, {}, [&texts](const Model&, const FoldedState&, const FoldedState& state) {
        texts.push_back(textOf(state));
        return true;
      });
  const Result<Replay> replayed = replay(model);
  ASSERT_TRUE(replayed.isOk());
  ASSERT_EQ(replayed->outcomes.size(), model.steps.size());
  for (std::size_t i = 0; i < model.steps.size(); ++i) {
    ASSERT_TRUE(replayed->outcomes[i].state) << replayed->outcomes[i].error->message;
    ASSERT_EQ(firstDifference(textOf(*replayed->outcomes[i].state), texts[i]), "")
        << trace(seed, model);
  }
}

TEST_P(RandomSteps, UndoneAndRedoneAreIdentical) {
  const std::uint64_t seed = GetParam() + 3000;
  const Model model =
      grow(seed, 30, {}, [](const Model&, const FoldedState&, const FoldedState&) { return true; });
  Model empty = model;
  empty.steps.clear();
  Result<History> history = History::open(empty);
  ASSERT_TRUE(history.isOk());
  std::vector<std::string> texts = {textOf(history->state())};
  for (const Step& step : model.steps) {
    const Status added = history->add(step);
    ASSERT_TRUE(added.isOk()) << added.error().message;
    texts.push_back(textOf(history->state()));
  }
  for (std::size_t i = model.steps.size(); i-- > 0;) {
    ASSERT_TRUE(history->undo());
    ASSERT_EQ(firstDifference(textOf(history->state()), texts[i]), "") << trace(seed, model);
  }
  EXPECT_FALSE(history->undo());
  for (std::size_t i = 1; i <= model.steps.size(); ++i) {
    ASSERT_TRUE(history->redo());
    ASSERT_EQ(firstDifference(textOf(history->state()), texts[i]), "") << trace(seed, model);
  }
  EXPECT_FALSE(history->redo());
}

TEST_P(RandomSteps, ResolvedGiveTheSameState) {
  const std::uint64_t seed = GetParam() + 4000;
  grow(seed, 40, {},
       [seed](const Model& model, const FoldedState& before, const FoldedState& state) {
         const int number = static_cast<int>(model.steps.size());
         const Result<Step> resolved = resolve(before, model.steps.back(), number);
         if (!resolved) {
           ADD_FAILURE() << trace(seed, model) << "\n" << resolved.error().message;
           return false;
         }
         const Result<FoldedState> again = apply(before, *resolved, number);
         if (!again) {
           ADD_FAILURE() << trace(seed, model) << "\nresolved: " << textOf(*resolved) << "\n"
                         << again.error().message;
           return false;
         }
         const bool isSame = hingeGap(*again) < 1e-7 &&
                             again->pattern.facets.size() == state.pattern.facets.size() &&
                             again->collisions.size() == state.collisions.size();
         EXPECT_TRUE(isSame) << trace(seed, model) << "\nresolved: " << textOf(*resolved);
         return isSame;
       });
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSteps, testing::Range<std::uint64_t>(1, 1 + kSeeds));

}  // namespace
}  // namespace kiri::test
