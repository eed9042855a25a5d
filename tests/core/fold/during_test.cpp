// Collisions on the way: what is recorded, and what the sentence offers.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

// A flap 50 long, 30 from a post that stands 50 high.
constexpr const char* kFlapAndPost =
    "rectangle 130 20; fold Post valley 90 80,0 80,20 right; fold Flap valley 1 50,0 50,20 left";

TEST(During, AFlapThatPassesAPostIsReportedWithAngleAndPlace) {
  const FoldedState state = after(run(kFlapAndPost), "angle Flap 170");
  ASSERT_EQ(state.collisions.size(), 1u);
  const Collision& c = state.collisions.front();
  EXPECT_EQ(c.moment, CollisionMoment::During);
  EXPECT_TRUE(c.isCertain);
  EXPECT_NEAR(c.degrees, 180 - std::acos(0.6) * 180 / std::numbers::pi, 1e-4);
  EXPECT_NEAR(c.place.x, 80, 1e-4);
  EXPECT_NEAR(c.place.z, 40, 1e-4);
  EXPECT_EQ(facetOf(state, c.moving), facetOf(state, {10, 10}));
  EXPECT_EQ(facetOf(state, c.fixed), facetOf(state, {120, 10}));
}

TEST(During, TheSentenceNamesTheFoldThatHoldsThePaperInTheWay) {
  const FoldedState state = after(run(kFlapAndPost), "angle Flap 170");
  ASSERT_EQ(state.collisions.size(), 1u);
  const std::string& message = state.collisions.front().message;
  EXPECT_NE(message.find("126.87 degrees"), std::string::npos) << message;
  EXPECT_NE(message.find("unfold \"Post\" first"), std::string::npos) << message;
}

TEST(During, FollowingTheAdviceHelps) {
  EXPECT_TRUE(isClean(after(run(kFlapAndPost), "unfold Post; angle Flap 170")));
  EXPECT_TRUE(isClean(after(run(kFlapAndPost), "angle Flap 126")));
}

TEST(During, AnglesAgainstTheDirectionOfTheFoldAreNegative) {
  const FoldedState state =
      run("rectangle 130 20; fold Post mountain 90 80,0 80,20 right; fold Flap valley 1 50,0 50,20 "
          "left; angle Flap -170");
  ASSERT_EQ(state.collisions.size(), 1u);
  EXPECT_NEAR(state.collisions.front().degrees, -126.8699, 1e-3);
}

TEST(During, AFreshFoldIsLookedAtToo) {
  const FoldedState state = run(
      "rectangle 130 20; fold Post valley 90 80,0 80,20 right; fold Flap valley 50,0 50,20 left");
  EXPECT_EQ(std::count_if(state.collisions.begin(), state.collisions.end(),
                          [](const Collision& c) { return c.moment == CollisionMoment::During; }),
            1);
}

}  // namespace
}  // namespace kiri::test
