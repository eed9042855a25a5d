// Sliders and the player on real models: paper stays rigid wherever they are dragged.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "core/model/history.h"
#include "editor/motion/all_slider.h"
#include "editor/motion/fold_sliders.h"
#include "editor/motion/player.h"
#include "tests/support/example_files.h"
#include "tests/support/expect.h"
#include "tests/support/state_check.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

class Example : public testing::TestWithParam<const char*> {
 protected:
  static Model model() { return test::modelOfExample(GetParam()); }
  static std::shared_ptr<const FoldedState> last() {
    return History::open(model()).value().sharedState();
  }
};

TEST_P(Example, OpensAndClosesAsItsStepsDo) {
  const auto state = last();
  const AllSlider slider = AllSlider::prepare(*state, model().opening).value();
  for (int i = 0; i <= 12; ++i) {
    const auto there = slider.at(i / 12.0);
    EXPECT_EQ(joined(poseViolations(*there)), "") << i;
  }
  EXPECT_TRUE(isSameState(*slider.at(slider.openness()), *state));
  EXPECT_FALSE(isFlat(*slider.at(0.37))) << "it is on its way";
  for (const double end : {0.0, 1.0}) {
    const std::optional<Step> step = slider.stepAt(end);
    if (!step) continue;
    const FoldedState done = apply(*state, *step, 0).value();
    EXPECT_EQ(firstDifference(textOf(*slider.at(end)), textOf(done)), "") << end;
  }
}

TEST_P(Example, EverySliderKeepsThePaperRigidAndItsStepDoesTheSame) {
  const auto state = last();
  for (const FoldSlider& slider : slidersOf(*state)) {
    constexpr double kAmount = 25;
    SCOPED_TRACE(slider.name);
    const SlideShow show = slideTo(*state, slider.line, kAmount);
    EXPECT_EQ(joined(poseViolations(*show.state)), "");
    EXPECT_EQ(show.stop.has_value(), show.amount != kAmount);
    const std::optional<Step> step = stepOfSlide(*state, slider.line, show.amount);
    if (!slider.canMove || !step) continue;
    const Result<FoldedState> done = apply(*state, *step, 0);
    ASSERT_TRUE(done.isOk()) << done.error().message;
    if (show.stop) {
      EXPECT_NEAR(amountOf(*done, slider.line).value(), show.amount, 1e-9);
    } else {
      EXPECT_EQ(firstDifference(textOf(*show.state), textOf(*done)), "");
    }
  }
}

TEST_P(Example, PlaysFromTheSheetToTheLastStep) {
  Player player;
  player.load(std::make_shared<const Timeline>(Timeline::of(model()).value()));
  player.play();
  while (player.isPlaying()) {
    player.advance(0.5);
    ASSERT_EQ(joined(poseViolations(player.state())), "") << player.seconds();
  }
  EXPECT_TRUE(isSameState(player.state(), *last()));
}

INSTANTIATE_TEST_SUITE_P(Files, Example,
                         testing::Values("leaf_palmate", "leaf_hornbeam", "ship", "straight_cut",
                                         "leaf_secondary_lobes", "kirigami_snowflake"),
                         [](const auto& file) { return std::string(file.param); });

}  // namespace
}  // namespace kiri::test
