// The time line of a model: what lies between the steps.
// SPDX-License-Identifier: MIT
#include "core/model/timeline.h"

#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// How far apart the corners of the facets lie in two states of one pattern.
double apart(const FoldedState& a, const FoldedState& b) {
  double most = 0;
  for (std::size_t f = 0; f < a.pattern.facets.size(); ++f) {
    for (const EdgeUse use : a.pattern.facets[f].border) {
      const Vec2 p = a.pattern[startOf(a.pattern, use)];
      most = std::max(most, distance(a.poses[f].apply(p), b.poses[f].apply(p)));
    }
  }
  return most;
}

constexpr const char* kFan =
    "square 100; fold one valley 50,-5 50,105 left; fold two valley -5,50 105,50 left";

TEST(StateBetween, HalfAFoldHasHalfItsAngle) {
  const Result<FoldedState> state = stateBetween(modelOf(kFan), 0.5);
  ASSERT_TRUE(state) << state.error().message;
  EXPECT_NEAR(*amountOf(*state, FoldLineId(0)), 90, 1e-9);
  EXPECT_EQ(violationsOf(*state), std::vector<std::string>{});
}

TEST(StateBetween, WholeNumbersAreTheStatesAfterSteps) {
  const Model model = modelOf(kFan);
  for (const int steps : {0, 1, 2}) {
    const Result<FoldedState> state = stateBetween(model, steps);
    ASSERT_TRUE(state);
    const Result<Replay> whole = replay(model);
    EXPECT_EQ(apart(*state, **whole->after(static_cast<std::size_t>(steps))), 0);
  }
}

TEST(StateBetween, UnfoldingInOrderTakesTheFoldsOneAfterTheOther) {
  const Model model = modelOf(std::string(kFan) + "; unfold all");
  const Result<FoldedState> quarter = stateBetween(model, 2.25);
  ASSERT_TRUE(quarter) << quarter.error().message;
  EXPECT_NEAR(*amountOf(*quarter, FoldLineId(0)), 180, 1e-9);
  EXPECT_NEAR(*amountOf(*quarter, FoldLineId(1)), 90, 1e-9);
  const Result<FoldedState> last = stateBetween(model, 2.75);
  EXPECT_NEAR(*amountOf(*last, FoldLineId(0)), 90, 1e-9);
  EXPECT_NEAR(*amountOf(*last, FoldLineId(1)), 0, 1e-9);
}

TEST(StateBetween, FoldsOfAFanOpenTogether) {
  const Model model = modelOf(
      "square 100; fold one valley 50,0 50,105 left; unfold all; fold two mountain 50,0 105,60 "
      "right; "
      "unfold all; refold all; unfold all together");
  const double steps = static_cast<double>(model.steps.size());
  const Result<FoldedState> half = stateBetween(model, steps - 0.5);
  ASSERT_TRUE(half) << half.error().message;
  EXPECT_NEAR(*amountOf(*half, FoldLineId(0)), 90, 1e-9);
  EXPECT_NEAR(*amountOf(*half, FoldLineId(1)), 90, 1e-9);
  EXPECT_EQ(violationsOf(*half), std::vector<std::string>{});
}

TEST(StateBetween, AModelThatIsTurnedOverStandsUprightHalfWay) {
  const Result<FoldedState> half = stateBetween(modelOf("square 100; turn"), 0.5);
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->poses[0].normal().z, 0, 1e-12);
}

TEST(StateBetween, RefusesMomentsThatTheModelDoesNotHave) {
  EXPECT_EQ(stateBetween(modelOf(kFan), 2.5).error().code, ErrorCode::BadValue);
  EXPECT_EQ(stateBetween(modelOf(kFan), -1).error().code, ErrorCode::BadValue);
}

TEST(StateBetween, ReportsTheStepThatDoesNotApply) {
  const Result<FoldedState> state =
      stateBetween(modelOf("square 100; fold a valley 200,0 200,9 left"), 0.5);
  ASSERT_FALSE(state);
  EXPECT_NE(state.error().message.find("step 1"), std::string::npos);
}

TEST(Timeline, LastsAsLongAsItsTurnsAndRests) {
  TimelineOptions options;
  options.degreesPerSecond = 90;
  options.startHold = 1;
  options.hold = 0.5;
  options.endHold = 2;
  const Result<Timeline> line = Timeline::of(modelOf(kFan), options);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->duration(), 1 + 2 + 0.5 + 2 + 2, 1e-12);
}

TEST(Timeline, TurnsAtConstantSpeedWithoutEasing) {
  TimelineOptions options;
  options.easing = Easing::None;
  options.degreesPerSecond = 90;
  options.startHold = 0;
  const Result<Timeline> line = Timeline::of(modelOf(kFan), options);
  for (const double seconds : {0.25, 0.5, 1.0, 1.75}) {
    EXPECT_NEAR(*amountOf(line->stateAt(seconds), FoldLineId(0)), 90 * seconds, 1e-9);
  }
}

TEST(Timeline, TimesOutsideAreItsEnds) {
  const Result<Timeline> line = Timeline::of(modelOf(kFan));
  EXPECT_EQ(apart(line->stateAt(-5), line->stateAfter(0)), 0);
  EXPECT_EQ(apart(line->stateAt(1e6), line->stateAfter(2)), 0);
}

TEST(Timeline, StopsWhenProgressSaysSo) {
  const Result<Timeline> line = Timeline::of(modelOf(kFan), {}, [](double) { return false; });
  EXPECT_EQ(line.error().code, ErrorCode::Cancelled);
}

TEST(Timeline, RefusesSpeedsThatAreNone) {
  TimelineOptions options;
  options.degreesPerSecond = 0;
  EXPECT_EQ(Timeline::of(modelOf(kFan), options).error().code, ErrorCode::BadValue);
}

/// Random models, each step of which is looked at on its way.
class MovementsOfRandomSteps : public ::testing::TestWithParam<int> {};

TEST_P(MovementsOfRandomSteps, StartAndEndWithTheStatesOfTheStepsAndNeverStretch) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  Model model = randomSheet(random);
  FoldedState state = startOf(model);
  RandomStepOptions options;
  for (int i = 0; i < 14; ++i) {
    const Step step = randomStep(random, state, options);
    Movements movements;
    Result<FoldedState> next = apply(state, step, i + 1, &movements);
    if (!next) continue;
    model.steps.push_back(step);
    for (const Movement& movement : movements) {
      for (const double part : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        const FoldedState there = stateDuring(movement, part);
        EXPECT_LE(stretchOf(there), 1e-9 * state.tolerance().sheetSize()) << textOf(model);
      }
    }
    if (!movements.empty()) {
      EXPECT_LE(apart(stateDuring(movements.back(), 1), *next), state.tolerance().match())
          << textOf(model);
    }
    state = std::move(*next);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, MovementsOfRandomSteps, ::testing::Range(1, 61));

}  // namespace
}  // namespace kiri::test
