// Sliders of fold lines that are held in closed loops of creases.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/fold/fold_line.h"
#include "core/geometry/rigid.h"
#include "core/model/timeline.h"
#include "tests/support/model_text.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// An inside reverse fold (thesis Figure 4.4): around its vertex the spine OP turns by m and the
/// two side creases by s, all four together or not at all.
const char* const kTuck =
    "square 100; fold OP valley 0,0 100,100 to 20,80; unfold OP; tear 0,0 40,40;"
    "fold QN valley 40,40 0,26.2 to 1,3; fold MN valley 40,40 26.2,0 to 3,1; refold OP; mend";

FoldLineId lineNamed(const FoldedState& state, const std::string& name) {
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    if (state.lines[i].name == name) return FoldLineId(i);
  }
  ADD_FAILURE() << "no line " << name;
  return FoldLineId(0);
}

/// m for s by tan(m / 2) = cos(a) tan(s / 2), a the angle between spine and side crease.
double spineFor(double side) {
  const double a = std::atan2(40, 40) - std::atan2(13.8, 40);
  const double half = side / 2 * M_PI / 180;
  return 2 * std::atan2(std::cos(a) * std::sin(half), std::cos(half)) * 180 / M_PI;
}

TEST(Slide, OfOneCreaseOpensAWholeReverseFold) {
  FoldedState state = run(kTuck);
  const FoldLineId side = lineNamed(state, "QN");
  for (const double s : {150.0, 90.0, 45.0, 5.0, 70.0, 170.0}) {
    Slide slide = slideAmount(state, side, s);
    ASSERT_FALSE(slide.why) << slide.why->message;
    EXPECT_NEAR(slide.amount, s, 1e-9);
    state = std::move(slide.state);
    EXPECT_NEAR(*amountOf(state, lineNamed(state, "MN")), s, 1e-7);
    EXPECT_NEAR(*amountOf(state, lineNamed(state, "OP")), spineFor(s), 1e-7);
    EXPECT_EQ(violationsOf(state), std::vector<std::string>{}) << s;
  }
}

TEST(Slide, ToNothingLeavesTheSheetFlat) {
  const FoldedState flat = after(run(kTuck), "angle QN 0");
  for (const FoldLine& line : flat.lines) EXPECT_EQ(amountOf(flat, lineNamed(flat, line.name)), 0);
  EXPECT_EQ(flat.layers.sets().size(), 1u);
  EXPECT_EQ(violationsOf(flat), std::vector<std::string>{});
}

TEST(Slide, FromTheFlatSheetFoldsTheTuckAgain) {
  const FoldedState half = after(run(kTuck), "angle QN 0; angle QN 60");
  EXPECT_NEAR(*amountOf(half, lineNamed(half, "OP")), spineFor(60), 1e-7);
  const FoldedState whole = after(half, "angle QN 180");
  EXPECT_EQ(amountOf(whole, lineNamed(whole, "OP")), 180);
  EXPECT_TRUE(isFlat(whole));
  EXPECT_EQ(violationsOf(whole), std::vector<std::string>{});
}

TEST(Slide, OfALineThatNothingFreesStaysAndSaysWhy) {
  const FoldedState cross =
      run("square 100; fold one valley 50,-5 50,105 left; fold two valley 90 -5,50 105,50 left");
  const Slide slide = slideAmount(cross, lineNamed(cross, "one"), 90);
  ASSERT_TRUE(slide.why);
  EXPECT_EQ(slide.why->code, ErrorCode::Locked);
  EXPECT_NE(slide.why->message.find("\"two\""), std::string::npos);
  EXPECT_EQ(slide.amount, 180);
}

TEST(Unfold, TogetherOpensWhatNoOrderOfFoldsCan) {
  const Model model = modelOf(std::string(kTuck) + "; unfold together");
  const double steps = static_cast<double>(model.steps.size());
  const Result<FoldedState> half = stateBetween(model, steps - 0.5);
  ASSERT_TRUE(half) << half.error().message;
  const double s = *amountOf(*half, lineNamed(*half, "QN"));
  EXPECT_GT(s, 20);
  EXPECT_LT(s, 160);
  EXPECT_NEAR(*amountOf(*half, lineNamed(*half, "OP")), spineFor(s), 1e-7);
  EXPECT_EQ(violationsOf(*half), std::vector<std::string>{});
}

TEST(Refold, TogetherFoldsATuckWithItsLayersRight) {
  const FoldedState folded = run(kTuck);
  const FoldedState again = after(folded, "unfold together; refold together");
  EXPECT_TRUE(isFlat(again));
  EXPECT_EQ(violationsOf(again), std::vector<std::string>{});
  for (std::size_t e = 0; e < folded.pattern.edges.size(); ++e)
    EXPECT_EQ(again.pattern.edges[e].angle, folded.pattern.edges[e].angle);
}

}  // namespace
}  // namespace kiri::test
