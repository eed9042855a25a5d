// Folding along creases that are there already, flat or folded.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

/// Four facets: the left half lies on the right one, torn in two halfway up.
const char* const kParted =
    "square 100; edge 0,50 50,50; fold A valley 50,0 50,100 left; tear 0,50 50,50; ";

std::string degreesText(double degrees) { return std::to_string(degrees); }

void expectSameAngles(const FoldedState& a, const FoldedState& b, const std::string& where) {
  ASSERT_EQ(a.pattern.edges.size(), b.pattern.edges.size()) << where;
  for (std::size_t e = 0; e < a.pattern.edges.size(); ++e)
    EXPECT_NEAR(a.pattern.edges[e].angle, b.pattern.edges[e].angle, 1e-9) << where;
  for (const Vec2 p : a.pattern.vertices) EXPECT_TRUE(liesAt(a, p, modelOf(b, p))) << where;
}

TEST(FoldOnCrease, TurnsAFoldByAsMuchAsSettingItsAngleDoes) {
  for (const double from : {0.0, 30.0, 90.0, 135.0, 180.0}) {
    for (const double by : {-180.0, -90.0, -45.0, 0.0, 45.0}) {
      if (from + by > 180 || from + by < -180) continue;
      const std::string start =
          "square 100; fold A valley " + degreesText(from) + " 50,0 50,100 left; ";
      const std::string where = "from " + degreesText(from) + " by " + degreesText(by);
      const FoldedState set = run(start + "angle A " + degreesText(from + by));
      // A facet that lies over the line's other side is moved from there.
      const std::string side = from > 90 ? "right" : "left";
      const bool isTowards = (by > 0) == (from <= 90);  // an open leaf is closed towards the viewer
      const FoldedState folded =
          run(start + "fold B " + (isTowards ? "valley " : "mountain ") +
              degreesText(std::abs(by)) + " 50,0 50,100 " + side + " facets p:25,50 in 25,50");
      expectSameAngles(folded, set, where);
      EXPECT_TRUE(isSound(folded)) << where;
    }
  }
}

TEST(FoldOnCrease, FoldsAgainWhereThePaperWasPreCreased) {
  const FoldedState fresh = run("square 100; fold B valley 50,0 50,100 left");
  const FoldedState again = run(
      "square 100; fold A mountain 50,0 50,100 right; unfold all; fold B valley 50,0 50,100 left");
  expectSameAngles(again, fresh, "pre-creased");
  EXPECT_TRUE(isClean(again));
  EXPECT_EQ(facetCount(again), 2u);
  EXPECT_EQ(anglesOf(again, "B"), (std::vector<double>{180}));
  EXPECT_TRUE(anglesOf(again, "A").empty());
}

TEST(FoldOnCrease, OpensOnePartOfAFoldThatATearHasParted) {
  const std::string opened =
      std::string(kParted) + "fold B valley 50,50 50,100 moving 25,75 facets 25,75 in 25,75; ";
  const FoldedState state = run(opened);
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {0, 75}, {0, 75, 0}));
  EXPECT_TRUE(liesAt(state, {0, 25}, {100, 25, 0}));
  EXPECT_EQ(anglesOf(state, "A"), (std::vector<double>{180}));
  EXPECT_EQ(anglesOf(state, "B"), (std::vector<double>{0}));

  // From now on each part has a name of its own, and is folded as it was folded first.
  const FoldedState half = run(opened + "angle B 90");
  EXPECT_TRUE(liesAt(half, {0, 75}, {50, 75, 50}));
  EXPECT_TRUE(liesAt(half, {0, 25}, {100, 25, 0}));
  const FoldedState back = run(opened + "refold B");
  EXPECT_TRUE(isClean(back));
  EXPECT_TRUE(isAbove(back, {25, 75}, {75, 75}));
  const FoldedState flat = run(opened + "unfold all");
  EXPECT_TRUE(isClean(flat));
  EXPECT_TRUE(liesAt(flat, {0, 25}, {0, 25, 0}));
  EXPECT_TRUE(liesAt(flat, {0, 75}, {0, 75, 0}));
}

TEST(FoldOnCrease, TurnsTheTopLayersAlongAFoldedEdge) {
  // Four layers; the two creases of B lie one in the other and are joined by that of A.
  const std::string opened =
      "square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left; "
      "fold C valley @model 110,50 40,50 to m:75,25 top 1; ";
  const FoldedState state = run(opened);
  EXPECT_TRUE(isSound(state));
  EXPECT_TRUE(liesAt(state, {100, 100}, {100, 100, 0}));
  EXPECT_TRUE(liesAt(state, {0, 100}, {100, 100, 0}));
  EXPECT_EQ(anglesOf(state, "C"), (std::vector<double>{0, 0}));
  EXPECT_TRUE(isClean(run(opened + "refold C")));
}

TEST(FoldOnCrease, SaysWhichCreaseLiesThereWhenNoLayersWereChosen) {
  const std::string folded = "square 100; fold A valley 50,0 50,100 left; ";
  for (const std::string layers : {"", " facets p:25,50 p:75,50"}) {
    const Result<FoldedState> result =
        tryRun(folded + "fold B valley @model 50,0 50,100 right" + layers);
    EXPECT_TRUE(failsWith(result, ErrorCode::MissesPaper,
                          "the crease of \"A\" lies along it, folded by 180 degrees"));
    EXPECT_TRUE(failsWith(result, ErrorCode::MissesPaper, "to turn all of \"A\", set its angle"));
  }
}

TEST(FoldOnCrease, MovesTheChosenSideWhenLayersOnBothSidesAreMeant) {
  const FoldedState state =
      run("square 100; fold A valley 50,0 50,100 left; fold B valley 50,0 50,100 moving 25,50 in "
          "25,50");
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(liesAt(state, {0, 50}, {0, 50, 0}));
  EXPECT_TRUE(liesAt(state, {100, 50}, {100, 50, 0}));
}

TEST(FoldOnCrease, RefusesCreasesThatAreFoldedByDifferentAngles) {
  const Result<FoldedState> result =
      tryRun(std::string(kParted) +
             "fold B valley 90 50,50 50,100 moving 25,75 facets 25,75 in "
             "25,75; fold C valley 50,0 50,100 moving 75,25 75,75 in 75,25");
  EXPECT_TRUE(failsWith(result, ErrorCode::BadValue, "different angles"));
}

}  // namespace
}  // namespace kiri::test
