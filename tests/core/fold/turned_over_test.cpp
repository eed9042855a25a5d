// Fold lines of which a part was turned over by other folds, and folds that cannot open in order.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <vector>

#include "core/fold/fold_line.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// A crease along the middle, and its right end turned behind together with the paper there.
const char* const kFlapOnCrease =
    "square 100; fold middle mountain 0,50 100,50 left; unfold middle;"
    "fold flap mountain 90,-5 90,105 right";

TEST(TurnedOver, FoldsWithTheRestTheOtherWayRound) {
  const FoldedState state = run(std::string(kFlapOnCrease) + "; refold middle");
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(violationsOf(state), std::vector<std::string>{});
  EXPECT_DOUBLE_EQ(amountOf(state, "middle"), 180);
  EXPECT_EQ(anglesOf(state, "middle"), (std::vector<double>{-180, 180}));
}

TEST(TurnedOver, LiesAsAFreshFoldAlongTheSameLineDoes) {
  for (const char* angle : {"180", "70"}) {
    const FoldedState again = run(std::string(kFlapOnCrease) + "; angle middle " + angle);
    const FoldedState fresh = run(std::string(kFlapOnCrease) + "; fold anew mountain " + angle +
                                  " @model 0,50 90,50 left");
    ASSERT_EQ(again.poses.size(), fresh.poses.size());
    for (std::size_t f = 0; f < again.poses.size(); ++f) {
      const Vec2 p = interiorPointOf(again.pattern, FacetId(f));
      EXPECT_TRUE(liesAt(again, p, modelOf(fresh, p))) << angle;
    }
    ASSERT_EQ(again.pattern.edges.size(), fresh.pattern.edges.size());
    for (std::size_t e = 0; e < again.pattern.edges.size(); ++e)
      EXPECT_DOUBLE_EQ(again.pattern.edges[e].angle, fresh.pattern.edges[e].angle) << angle;
  }
}

TEST(TurnedOver, OpensAgainAndFoldsAsAtFirstWhenItWasTurnedBack) {
  const FoldedState open = run(std::string(kFlapOnCrease) + "; refold middle; unfold middle");
  EXPECT_TRUE(isClean(open));
  EXPECT_EQ(anglesOf(open, "middle"), (std::vector<double>{0, 0}));
  const FoldedState back = after(open, "unfold flap; refold middle");
  EXPECT_TRUE(isClean(back));
  EXPECT_EQ(anglesOf(back, "middle"), (std::vector<double>{-180, -180}));
}

TEST(TurnedOver, TogetherFirstTurnsBackWhatOtherFoldsCanTurnBack) {
  // "across" goes through both layers of "half": opened, its two halves ask for opposite turns.
  const FoldedState folded =
      run("square 100; fold half valley 50,0 50,100 left; fold across valley @model 45,40 105,40 "
          "left");
  const FoldedState again = after(folded, "unfold all; refold across half together");
  for (std::size_t e = 0; e < folded.pattern.edges.size(); ++e)
    EXPECT_EQ(again.pattern.edges[e].angle, folded.pattern.edges[e].angle);
  EXPECT_TRUE(isClean(again));
}

/// A half, a fold through both of its layers that stands open, and a corner beside them.
const char* const kHeldInOrder =
    "square 100; fold corner valley 0,90 10,100 left; fold half valley 50,0 50,100 right;"
    "fold across valley 60 @model -5,40 55,40 right";

TEST(UnfoldInOrder, ThatIsRefusedSaysThatTogetherIsPossible) {
  const FoldedState state = run(kHeldInOrder);
  const Result<FoldedState> inOrder = tryAfter(state, "unfold across half");
  EXPECT_TRUE(failsWith(inOrder, ErrorCode::Locked, "these folds can move together"));
  const FoldedState open = after(state, "unfold across half together");
  EXPECT_DOUBLE_EQ(amountOf(open, "half"), 0);
  EXPECT_DOUBLE_EQ(amountOf(open, "corner"), 180);
}

TEST(UnfoldInOrder, OfAllThatIsFoldedAlwaysOpens) {
  const FoldedState open = after(run(kHeldInOrder), "unfold corner across half");
  EXPECT_EQ(violationsOf(open), std::vector<std::string>{});
  EXPECT_TRUE(isClean(open));
  for (const char* name : {"corner", "half", "across"}) EXPECT_DOUBLE_EQ(amountOf(open, name), 0);
}

/// The half is made first, opened for folds of one layer each, and closed over them again.
const char* const kClosedAgain =
    "square 100; fold half valley 50,0 50,100 left; unfold half;"
    "fold left valley 0,30 30,0 to 5,5; fold right valley 100,30 70,0 to 95,5; refold half";

TEST(UnfoldInOrder, OpensFirstWhatWasClosedOverOtherFolds) {
  const FoldedState folded = run(kClosedAgain);
  EXPECT_TRUE(isClean(folded));
  const FoldedState open = after(folded, "unfold all");
  EXPECT_TRUE(isClean(open));
  for (const char* name : {"half", "left", "right"}) EXPECT_DOUBLE_EQ(amountOf(open, name), 0);
  EXPECT_FALSE(after(folded, "unfold half left right").collisions.empty()) << "as it was told";
}

}  // namespace
}  // namespace kiri::test
