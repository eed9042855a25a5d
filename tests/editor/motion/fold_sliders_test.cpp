// Sliders of fold lines: what they show is what the step that they make does.
// SPDX-License-Identifier: MIT
#include "editor/motion/fold_sliders.h"

#include <gtest/gtest.h>

#include "core/fold/fold_line.h"
#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

const char* const kBook =
    "square 100; fold A valley 50,0 50,100 left; fold B mountain 90 75,0 75,100 left";
// Locked: A's crease runs on both sides of B's, which is folded flat.
const char* const kLocked =
    "square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left";

TEST(FoldSliders, ShowEveryFoldLineInTheOrderOfFolding) {
  const std::vector<FoldSlider> sliders = slidersOf(run(kBook));
  ASSERT_EQ(sliders.size(), 2u);
  EXPECT_EQ(sliders[0].name, "A");
  EXPECT_TRUE(sliders[0].isValley);
  EXPECT_DOUBLE_EQ(sliders[0].amount.value(), 180);
  EXPECT_EQ(sliders[1].name, "B");
  EXPECT_FALSE(sliders[1].isValley);
  EXPECT_DOUBLE_EQ(sliders[1].amount.value(), 90);
  EXPECT_TRUE(sliders[1].canMove);
}

TEST(FoldSliders, SayTheSameAsTheKernelOfEveryLine) {
  int disagreeing = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    FoldedState state = startOf(randomSheet(random));
    for (int i = 1; i <= 30; ++i) {
      Result<FoldedState> next = apply(state, randomStep(random, state, {}), i);
      if (next) state = std::move(*next);
    }
    for (const FoldSlider& slider : slidersOf(state)) {
      EXPECT_EQ(slider.amount, amountOf(state, slider.line)) << "seed " << seed;
      EXPECT_EQ(slider.canMove, !hingesOf(state, slider.line).empty());
      disagreeing += slider.canMove && !slider.amount ? 1 : 0;
    }
  }
  EXPECT_GT(disagreeing, 0);
}

TEST(FoldSliders, ALineWhoseCreaseIsTornCannotMove) {
  const std::vector<FoldSlider> sliders =
      slidersOf(run("square 100; fold A valley 50,0 50,100 left; angle A 0; tear 50,0 50,100"));
  ASSERT_EQ(sliders.size(), 1u);
  EXPECT_FALSE(sliders[0].canMove);
  EXPECT_FALSE(sliders[0].amount.has_value());
}

TEST(FoldSliders, ShowWhatTheStepDoesAtEveryAngle) {
  const FoldedState from = run(kBook);
  for (int degrees = -180; degrees <= 180; degrees += 15) {
    const SlideShow show = slideTo(from, FoldLineId(1), degrees);
    EXPECT_FALSE(show.stop.has_value());
    EXPECT_DOUBLE_EQ(show.amount, degrees);
    const std::optional<Step> step = stepOfSlide(from, FoldLineId(1), degrees);
    if (degrees == 90) {
      EXPECT_FALSE(step.has_value()) << "nothing changed";
      continue;
    }
    const FoldedState done = apply(from, step.value(), 0).value();
    EXPECT_EQ(firstDifference(textOf(*show.state), textOf(done)), "") << degrees;
  }
}

TEST(FoldSliders, DraggingBackUndoesExactly) {
  const FoldedState from = run(kBook);
  slideTo(from, FoldLineId(1), 20);
  const SlideShow back = slideTo(from, FoldLineId(1), 90);
  EXPECT_TRUE(isSameState(*back.state, from));
}

TEST(FoldSliders, AngleBeyondHalfATurnAreCutOff) {
  EXPECT_DOUBLE_EQ(slideTo(run(kBook), FoldLineId(1), 700).amount, 180);
  EXPECT_DOUBLE_EQ(slideTo(run(kBook), FoldLineId(1), -700).amount, -180);
}

TEST(FoldSliders, ALockedLineStopsWhereItIsAndSaysWhy) {
  const FoldedState from = run(kLocked);
  const SlideShow show = slideTo(from, FoldLineId(0), 90);
  ASSERT_TRUE(show.stop.has_value());
  EXPECT_EQ(show.stop->code, ErrorCode::Locked);
  EXPECT_NE(show.stop->message.find("\"B\""), std::string::npos) << show.stop->message;
  EXPECT_DOUBLE_EQ(show.amount, 180);
  EXPECT_TRUE(isSameState(*show.state, from));
  EXPECT_FALSE(stepOfSlide(from, FoldLineId(0), show.amount).has_value());
}

TEST(FoldSliders, ACollisionIsReportedAndDoesNotStop) {
  // The flap of B stands on the way of A's other side.
  const FoldedState from =
      run("square 100; fold A valley 0 50,0 50,100 left; fold B valley 90 20,0 20,100 left");
  ASSERT_TRUE(from.collisions.empty());
  const SlideShow show = slideTo(from, FoldLineId(1), -180);
  EXPECT_FALSE(show.stop.has_value());
  const SlideShow through =
      slideTo(run("square 100; fold A valley 60,0 60,100 left; fold B mountain 90 @model 80,0 "
                  "80,100 left top 1"),
              FoldLineId(1), 180);
  EXPECT_FALSE(through.stop.has_value());
  EXPECT_DOUBLE_EQ(through.amount, 180);
  EXPECT_FALSE(through.collisions.empty());
  EXPECT_FALSE(through.collisions.front().message.empty());
}

TEST(FoldSliders, LinesInClosedLoopsGoAsFarAsThePaperLetsThemAndTheStepDoesTheSame) {
  // An inside reverse fold (thesis Figure 4.4).
  const FoldedState from = run(
      "square 100; fold OP valley 0,0 100,100 to 20,80; unfold OP; tear 0,0 40,40;"
      "fold QN valley 40,40 0,26.2 to 1,3; fold MN valley 40,40 26.2,0 to 3,1; refold OP; mend");
  int moved = 0;
  for (const FoldSlider& slider : slidersOf(from)) {
    for (const double amount : {150.0, 90.0, 33.3, 0.0, -50.0, -180.0}) {
      SCOPED_TRACE(slider.name + " to " + std::to_string(amount));
      const SlideShow show = slideTo(from, slider.line, amount);
      EXPECT_EQ(joined(poseViolations(*show.state)), "");
      EXPECT_EQ(show.stop.has_value(), show.amount != amount);
      const std::optional<Step> step = stepOfSlide(from, slider.line, show.amount);
      if (!step) continue;
      ++moved;
      const Result<FoldedState> done = apply(from, *step, 0);
      ASSERT_TRUE(done.isOk()) << done.error().message;
      EXPECT_EQ(joined(poseViolations(*done)), "");
      EXPECT_NEAR(amountOf(*done, slider.line).value(), show.amount, 1e-9);
    }
  }
  EXPECT_GT(moved, 6);
}

TEST(SliderGroups, AreOfNamesThatDifferInANumber) {
  const auto named = [](const char* name) {
    FoldSlider slider;
    slider.name = name;
    return slider;
  };
  const std::vector<FoldSlider> sliders{named("mid vein"), named("vein 1"), named("base"),
                                        named("vein 2"),   named("7"),      named("tip 3")};
  const std::vector<SliderGroup> groups = groupsOf(sliders);
  ASSERT_EQ(groups.size(), 5u);
  EXPECT_EQ(groups[0].name, "mid vein");
  EXPECT_EQ(groups[1].name, "vein");
  EXPECT_EQ(groups[1].rows, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(groups[3].name, "7");
  EXPECT_EQ(groups[4].name, "tip 3") << "one alone keeps its name";
}

}  // namespace
}  // namespace kiri::test
