// The slider for all: between folded and unfolded, as the steps at its ends do it.
// SPDX-License-Identifier: MIT
#include "editor/motion/all_slider.h"

#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/state_check.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

const char* const kTwo =
    "square 100; fold A valley 50,0 50,100 left; fold B mountain 90 75,0 75,100 left";

class EitherSequence : public testing::TestWithParam<Sequence> {
 protected:
  AllSlider prepared(const FoldedState& state) const {
    return AllSlider::prepare(state, GetParam()).value();
  }
};

TEST_P(EitherSequence, EndsAreWhatTheStepsDo) {
  const FoldedState folded = run(kTwo);
  const AllSlider opening = prepared(folded);
  EXPECT_DOUBLE_EQ(opening.openness(), 0);
  EXPECT_TRUE(isSameState(*opening.at(0), folded));
  EXPECT_FALSE(opening.stepAt(0).has_value()) << "it is folded";
  const FoldedState open = apply(folded, opening.stepAt(1).value(), 0).value();
  EXPECT_EQ(firstDifference(textOf(*opening.at(1)), textOf(open)), "");

  const AllSlider closing = prepared(open);
  EXPECT_DOUBLE_EQ(closing.openness(), 1);
  EXPECT_FALSE(closing.stepAt(1).has_value()) << "it is open";
  const FoldedState again = apply(open, closing.stepAt(0).value(), 0).value();
  EXPECT_EQ(firstDifference(textOf(*closing.at(0)), textOf(again)), "");
}

TEST_P(EitherSequence, PaperStaysRigidBetweenTheEndsAndNoStepIsMade) {
  const FoldedState folded = run(kTwo);
  const AllSlider slider = prepared(folded);
  double last = 270;
  for (int i = 1; i < 20; ++i) {
    const double openness = i / 20.0;
    const auto state = slider.at(openness);
    EXPECT_EQ(joined(poseViolations(*state)), "") << openness;
    const double turned = std::abs(amountOf(*state, FoldLineId(0)).value()) +
                          std::abs(amountOf(*state, FoldLineId(1)).value());
    EXPECT_LT(turned, last) << "it only opens";
    last = turned;
    EXPECT_FALSE(slider.stepAt(openness).has_value());
  }
}

TEST_P(EitherSequence, AHalfOpenModelStandsBetweenTheEnds) {
  const FoldedState half = after(run(kTwo), "unfold B");
  const AllSlider slider = prepared(half);
  EXPECT_GT(slider.openness(), 0);
  EXPECT_LT(slider.openness(), 1);
  EXPECT_TRUE(isSameState(*slider.at(slider.openness()), half));
  EXPECT_DOUBLE_EQ(amountOf(*slider.at(0), "B"), 90);
  EXPECT_DOUBLE_EQ(amountOf(*slider.at(1), "A"), 0);
  EXPECT_TRUE(std::holds_alternative<RefoldStep>(slider.stepAt(0)->action));
  EXPECT_TRUE(std::holds_alternative<UnfoldStep>(slider.stepAt(1)->action));
}

INSTANTIATE_TEST_SUITE_P(Both, EitherSequence,
                         testing::Values(Sequence::InOrder, Sequence::Together));

TEST(AllSlider, TogetherMovesAllLinesAtOnceAndInOrderOneAfterTheOther) {
  const FoldedState folded =
      run("square 100; fold A valley 25,0 25,100 left; fold B mountain 90 75,0 75,100 right");
  const auto together = AllSlider::prepare(folded, Sequence::Together)->at(0.5);
  EXPECT_NEAR(amountOf(*together, "A"), 90, 1);
  EXPECT_NEAR(amountOf(*together, "B"), 45, 1);
  const auto inOrder = AllSlider::prepare(folded, Sequence::InOrder)->at(0.2);
  EXPECT_DOUBLE_EQ(amountOf(*inOrder, "A"), 180) << "the last fold opens first";
  EXPECT_NEAR(amountOf(*inOrder, "B"), 90 - 0.2 * 270, 1e-9);
}

TEST(AllSlider, CanBeStoppedWhileItLooksForTheWays) {
  const FoldedState folded = run(kTwo);
  double last = 0;
  int calls = 0;
  const auto counting = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
    ++calls;
    return true;
  };
  ASSERT_TRUE(AllSlider::prepare(folded, Sequence::Together, counting).isOk());
  EXPECT_GT(calls, 1);
  for (int stop = 1; stop <= calls; ++stop) {
    int left = stop;
    const Result<AllSlider> stopped =
        AllSlider::prepare(folded, Sequence::Together, [&left](double) { return --left > 0; });
    ASSERT_FALSE(stopped.isOk());
    EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  }
}

TEST(AllSlider, AFlatSheetHasNothingToOpen) {
  const Result<AllSlider> slider = AllSlider::prepare(run("square 100"), Sequence::Together);
  ASSERT_FALSE(slider.isOk());
  EXPECT_EQ(slider.error().code, ErrorCode::NothingToDo);
}

}  // namespace
}  // namespace kiri::test
