// What galleries show of a model: folded, half way, unfolded.
// SPDX-License-Identifier: MIT
#include "core/model/moments.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/model_text.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

constexpr const char* kMomentFan =
    "square 100; fold one valley 50,-5 50,105 left; fold two valley -5,50 105,50 left";

Moments momentsOfText(const std::string& text) {
  const Model model = modelOf(text);
  return momentsOf(model, Timeline::of(model).value());
}

/// The angles of the hinges, without signs, from the smallest.
std::vector<double> allAngles(const FoldedState& state) {
  std::vector<double> angles;
  for (const Edge& edge : state.pattern.edges)
    if (edge.kind == EdgeKind::Hinge) angles.push_back(std::abs(edge.angle));
  std::sort(angles.begin(), angles.end());
  return angles;
}

TEST(Moments, AModelThatIsUnfoldedAtTheEndIsFoldedBefore) {
  const Moments moments = momentsOfText(std::string(kMomentFan) + "; unfold all together");
  EXPECT_EQ(moments.folded, 2u);
  EXPECT_TRUE(moments.isOpenAtTheEnd);
  EXPECT_EQ(moments.halfWay, HalfWay::Unfolding);
  ASSERT_TRUE(moments.half);
  EXPECT_EQ(violationsOf(*moments.half), std::vector<std::string>{});
  const std::vector<double> angles = allAngles(*moments.half);
  EXPECT_TRUE(std::any_of(angles.begin(), angles.end(), [](double angle) {
    return angle > 10 && angle < 170;
  })) << "it does not lie flat";
}

TEST(Moments, AFoldedModelIsOpenedHalfAlthoughNoStepDoesIt) {
  const Moments moments = momentsOfText(kMomentFan);
  EXPECT_EQ(moments.folded, 2u);
  EXPECT_FALSE(moments.isOpenAtTheEnd);
  EXPECT_EQ(moments.halfWay, HalfWay::Unfolding);
  ASSERT_TRUE(moments.half);
  EXPECT_EQ(violationsOf(*moments.half), std::vector<std::string>{});
}

TEST(Moments, UnfoldedIsAllThePaperThatIsLeftAtRest) {
  const Moments moments =
      momentsOfText(std::string(kMomentFan) + "; cut @model 80,-5 80,105 through keep m:60,60");
  EXPECT_EQ(violationsOf(moments.unfolded), std::vector<std::string>{});
  for (const double angle : allAngles(moments.unfolded)) EXPECT_EQ(angle, 0);
  for (const Rigid& pose : moments.unfolded.poses)
    EXPECT_EQ(distance(pose.apply(Vec2{1, 2}), Vec3{1, 2, 0}), 0) << "the paper frame";
}

TEST(Moments, AFoldThatIsHalfUnfoldedStandsUpright) {
  const Moments moments = momentsOfText("square 100; fold one valley 50,-5 50,105 left");
  ASSERT_EQ(moments.halfWay, HalfWay::Unfolding);
  EXPECT_NEAR(allAngles(*moments.half).back(), 90, 1e-9);
}

TEST(Moments, OfSeveralFoldedMomentsThatOfMostFoldsCounts) {
  const std::string text =
      std::string(kMomentFan) + "; unfold all; fold three valley -5,25 105,25 left";
  EXPECT_EQ(momentsOfText(text).folded, 2u);
  EXPECT_FALSE(momentsOfText(text).isOpenAtTheEnd);
}

TEST(Moments, WhereNothingMovesThereIsNoHalf) {
  const Moments moments = momentsOfText("square 100; edge 0,50 100,50");
  EXPECT_EQ(moments.halfWay, HalfWay::None);
  EXPECT_FALSE(moments.half);
}

}  // namespace
}  // namespace kiri::test
