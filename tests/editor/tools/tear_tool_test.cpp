// Tearing along edges, and mending, by hand.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/model/apply.h"
#include "tests/editor/tools/examples.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

TearStep tearOf(const Step& step) { return std::get<TearStep>(step.action); }

const char* const kHalvedAndOpened = "square 100; fold A valley 50,0 50,100 left; unfold all";
const char* const kCross = "square 100; edge 50,0 50,100; edge 0,50 100,50";

TEST(TearTool, TheShipIsTornFoldedAndMendedAsInTheExample) {
  const Example ship = exampleOf("ship");
  ToolDriver hand(ToolId::Tear, ship.after(2));
  hand.hover({0, 0});
  EXPECT_GE(hand.count(MarkRole::Possible), 1U);
  hand.drag({0, 0}, {76, 76});
  ASSERT_TRUE(hand.proposal());
  EXPECT_TRUE(hand.proposal()->isComplete);
  hand.set("length", std::sqrt(2.0) * 75);
  hand.key(Key::Enter);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_EQ(edgeCount(hand.state(), EdgeKind::Tear), edgeCount(ship.after(3), EdgeKind::Tear));
  EXPECT_EQ(facetCount(hand.state()), facetCount(ship.after(3)));

  FoldedState state = hand.state();
  for (std::size_t number = 4; number <= 6; ++number) {
    auto next = apply(state, ship.step(number), static_cast<int>(number));
    ASSERT_TRUE(next) << next.error().message;
    state = std::move(*next);
  }
  ToolDriver mending(ToolId::Mend, state);
  EXPECT_TRUE(mending.field("all").isEnabled);
  EXPECT_TRUE(mending.push("all").wantsCommit);
  ASSERT_EQ(mending.steps().size(), 1U);
  EXPECT_EQ(edgeCount(mending.state(), EdgeKind::Tear), 0U);
  EXPECT_TRUE(isSound(mending.state()));
  const auto upright = apply(mending.state(), ship.step(8), 8);
  ASSERT_TRUE(upright);
  for (const Vec2 p : {Vec2{10, 60}, Vec2{60, 10}, Vec2{95, 90}, Vec2{4, 5}})
    EXPECT_TRUE(liesAt(*upright, p, modelOf(ship.after(8), p)));
}

TEST(TearTool, TornAndMendedIsAsItWas) {
  ToolDriver hand(ToolId::Tear, kHalvedAndOpened);
  hand.drag({50, 0}, {50, 100});
  EXPECT_EQ(tearOf(hand.step()).path.points.size(), 2U);
  hand.key(Key::Enter);
  EXPECT_EQ(pieceCount(hand.state()), 2U);
  ToolDriver mending(ToolId::Mend, hand.state());
  mending.hover({50, 70});
  EXPECT_EQ(mending.count(MarkRole::Hovered), 1U);
  mending.click({50, 70});
  ASSERT_GE(mending.steps().size(), 1U);
  EXPECT_EQ(pieceCount(mending.state()), 1U);
  EXPECT_EQ(edgeCount(mending.state(), EdgeKind::Hinge), 1U);
  EXPECT_TRUE(isSound(mending.state()));
}

TEST(TearTool, EndsInsideAnEdgeWhereTheHandLetsGo) {
  ToolDriver hand(ToolId::Tear, kHalvedAndOpened);
  hand.snaps.isOn = false;
  hand.drag({50, 0}, {52, 37});
  const std::vector<Vec2> points = tearOf(hand.step()).path.points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_LT(distance(points[0], {50, 0}), 1e-9);
  EXPECT_LT(distance(points[1], {50, 37}), 1e-6);
  EXPECT_NEAR(hand.field("length").value, 37, 1e-6);
  hand.set("length", 61.5);
  EXPECT_LT(distance(tearOf(hand.step()).path.points[1], {50, 61.5}), 1e-9);
  hand.set("length", 1000);
  EXPECT_LT(distance(tearOf(hand.step()).path.points[1], {50, 100}), 1e-9);
  hand.set("length", 20);
  EXPECT_TRUE(hand.commit());
  EXPECT_EQ(edgeCount(hand.state(), EdgeKind::Tear), 1U);
  EXPECT_EQ(edgeCount(hand.state(), EdgeKind::Hinge), 1U);
}

TEST(TearTool, TheEndOfATearCanBeTakenUpAgain) {
  ToolDriver hand(ToolId::Tear, kCross);
  hand.snaps.isOn = false;
  hand.drag({50, 0}, {50, 30});
  hand.drag({50, 30}, {50, 40});
  EXPECT_NEAR(hand.field("length").value, 40, 1e-6);
  hand.drag({50, 40}, {50, 50});
  hand.drag({50, 50}, {80, 50});
  EXPECT_NEAR(hand.field("length").value, 80, 1e-6);
  EXPECT_EQ(tearOf(hand.step()).path.points.size(), 3U);
  hand.held.alt = true;
  EXPECT_FALSE(hand.press({20, 20}).isHandled);  // that is for the eye
  hand.held.alt = false;
  EXPECT_TRUE(std::holds_alternative<AllLayers>(tearOf(hand.step()).layers));
  hand.drag({80, 50}, {50, 20});
  EXPECT_NEAR(hand.field("length").value, 20, 1e-6);
}

/// Where a tear ends that the hand draws so far, roughly.
Vec2 tornTo(const FoldedState& state, Vec2 from, Vec2 to, bool isFree = false) {
  ToolDriver hand(ToolId::Tear, state);
  hand.snaps.isOn = !isFree;
  hand.drag(from, to);
  return tearOf(hand.step()).path.points.back();
}

TEST(TearTool, IsAimedAtWhereTheFoldsAfterItWillEnd) {
  // Figure 7.16: the pocket of the cup. Its fold is the mirror image of the one before.
  const FoldedState cup = exampleOf("origami_cup").after(2);
  const double pocket = 100 * (3 - 2 * std::sqrt(2.0));
  EXPECT_NEAR(distance(tornTo(cup, {100, 0}, {17.8, 0.4}), {pocket, 0}), 0, 1e-9);
  EXPECT_NEAR(tornTo(cup, {100, 0}, {17.8, 0.4}, true).x, 17.8, 1e-6) << "Ctrl leaves it free";
  // Figure 7.11d: two folds that halve angles will meet on the added edge.
  const FoldedState bird = exampleOf("origami_bird").after(4);
  const double meeting = 100 * (std::sqrt(2.0) - 1);
  EXPECT_NEAR(distance(tornTo(bird, {0, 90}, {0.3, 41}), {0, meeting}), 0, 1e-9);
}

TEST(TearTool, FollowsAnEdgeUnderOtherPaperWhereNoneIsSeen) {
  // The diagonal of the bird lies under the edges that were folded to it.
  ToolDriver hand(ToolId::Tear, exampleOf("origami_bird").after(12));
  hand.snaps.isOn = false;
  hand.drag({100, 0}, {24, 0});
  const std::vector<Vec2> points = tearOf(hand.step()).path.points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(distance(points[1], {24, 0}), 0, 1e-6);
}

TEST(TearTool, TurnsCornersAndGoesBackWithTheHand) {
  ToolDriver hand(ToolId::Tear, kCross);
  hand.hover({50, 0});
  hand.press({50, 0});
  for (const Vec2 p : {Vec2{50, 20}, Vec2{50, 45}, Vec2{50, 50}, Vec2{60, 50}, Vec2{90, 51}})
    hand.moveTo(p);
  EXPECT_EQ(tearOf(hand.step()).path.points.size(), 3U);
  hand.moveTo({60, 50});
  hand.moveTo({50, 48});
  hand.moveTo({50, 36});
  EXPECT_EQ(tearOf(hand.step()).path.points.size(), 2U);
  EXPECT_NEAR(tearOf(hand.step()).path.points[1].y, 36, 1e-6);
  for (const Vec2 p : {Vec2{50, 50}, Vec2{30, 50}, Vec2{1, 50}}) hand.moveTo(p);
  hand.release({0, 50});
  const std::vector<Vec2> points = tearOf(hand.step()).path.points;
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1], (Vec2{50, 50}));
  EXPECT_EQ(points[2], (Vec2{0, 50}));
  hand.key(Key::Enter);
  EXPECT_EQ(pieceCount(hand.state()), 2U);
}

TEST(TearTool, ClicksFromVertexToVertexDoTheSame) {
  ToolDriver hand(ToolId::Tear, kCross);
  hand.click({50, 0});
  EXPECT_FALSE(hand.proposal());
  hand.hover({50, 40});
  EXPECT_FALSE(hand.proposal()->isComplete);
  hand.click({50, 50});
  hand.click({100, 50});
  hand.key(Key::Enter);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_EQ(tearOf(hand.steps()[0]).path.points.size(), 3U);
  EXPECT_EQ(pieceCount(hand.state()), 2U);
}

TEST(TearTool, AllLayersThatHaveTheEdgeOrOnlyTheOneThatIsSeen) {
  const FoldedState folded =
      run("square 100; fold A valley 50,0 50,100 left; edge @model 40,50 110,50");
  for (const Camera::Preset side : {Camera::Preset::Front, Camera::Preset::Back}) {
    ToolDriver hand(ToolId::Tear, folded);
    hand.look(side);
    hand.snaps.isOn = false;
    hand.drag({100, 50}, {70, 50});
    const auto all = hand.result();
    ASSERT_TRUE(all);
    EXPECT_EQ(edgeCount(*all, EdgeKind::Tear), 2U);
    hand.set("layers", 1);
    const auto one = hand.result();
    ASSERT_TRUE(one);
    EXPECT_EQ(edgeCount(*one, EdgeKind::Tear), 1U);
    hand.held.control = true;
    hand.wheel({80, 50}, 1);
    EXPECT_EQ(edgeCount(*hand.result(), EdgeKind::Tear), 2U);
    hand.wheel({80, 50}, -1);
    EXPECT_EQ(edgeCount(*hand.result(), EdgeKind::Tear), 1U);
    hand.held.control = false;
    hand.tool().reset();
    hand.held.alt = true;
    hand.drag({100, 50}, {70, 50});
    hand.held.alt = false;
    const auto again = hand.result();
    ASSERT_TRUE(again);
    EXPECT_EQ(edgeCount(*again, EdgeKind::Tear), 1U);
    for (const Edge& edge : again->pattern.edges) {
      if (edge.kind != EdgeKind::Tear) continue;
      const bool isOfLeftHalf = again->pattern[edge.from].x < 50;
      EXPECT_EQ(isOfLeftHalf, side == Camera::Preset::Front);
    }
  }
}

TEST(TearTool, EdgesUnderOtherPaperAreNotTaken) {
  // The right half has a crease that the left half, folded over it, hides.
  const FoldedState folded =
      run("square 100; edge 75,0 75,100; fold A valley 50,0 50,100 left facets 25,50");
  ToolDriver hand(ToolId::Tear, folded);
  hand.snaps.isOn = false;
  hand.hover({75, 50});
  EXPECT_EQ(hand.count(MarkRole::Possible), 0U);
  hand.drag({50, 0}, {75, 60});  // nearer to the hidden crease than to the fold
  const std::vector<Vec2> hidden = tearOf(hand.step()).path.points;
  for (const Vec2 p : hidden) EXPECT_NEAR(p.x, 50, 1e-9);
  hand.look(Camera::Preset::Back);
  hand.tool().reset();
  hand.drag({75, 0}, {75, 60});  // from the back it is seen
  const std::vector<Vec2> seen = tearOf(hand.step()).path.points;
  for (const Vec2 p : seen) EXPECT_NEAR(p.x, 75, 1e-9);
}

TEST(TearTool, FromTheSheetTheSameEdgesAreTorn) {
  ToolDriver hand(ToolId::Tear, kCross);
  hand.pane = Pane::Sheet;
  hand.drag({50, 0}, {50, 50});
  EXPECT_EQ(tearOf(hand.step()).path.points.back(), (Vec2{50, 50}));
  EXPECT_EQ(edgeCount(*hand.result(), EdgeKind::Tear), 1U);
}

TEST(TearTool, PlainPaperIsLeftToTheEye) {
  ToolDriver hand(ToolId::Tear, "square 100");
  EXPECT_FALSE(hand.press({0, 0}).isHandled);
  EXPECT_FALSE(hand.release({0, 0}).isHandled);
  EXPECT_FALSE(hand.proposal());
  ToolDriver crossed(ToolId::Tear, kCross);
  EXPECT_FALSE(crossed.press({20, 20}).isHandled);
}

TEST(TearTool, EscapeLeavesThePaperWhole) {
  ToolDriver hand(ToolId::Tear, kHalvedAndOpened);
  hand.drag({50, 0}, {50, 100});
  EXPECT_TRUE(hand.key(Key::Escape).isHandled);
  EXPECT_FALSE(hand.proposal());
  EXPECT_FALSE(hand.tool().isBusy());
}

TEST(MendTool, MendsTheWholeTearOrOneEdgeOfIt) {
  const FoldedState torn = run(std::string(kCross) + "; tear 50,0 50,50 100,50");
  ToolDriver whole(ToolId::Mend, torn);
  whole.click({50, 25});
  EXPECT_EQ(edgeCount(whole.state(), EdgeKind::Tear), 0U);
  ToolDriver one(ToolId::Mend, torn);
  one.held.alt = true;
  one.click({50, 25});
  EXPECT_EQ(edgeCount(one.state(), EdgeKind::Tear), 1U);
  ToolDriver chosen(ToolId::Mend, torn);
  chosen.set("reach", 1);
  chosen.click({75, 50});
  EXPECT_EQ(edgeCount(chosen.state(), EdgeKind::Tear), 1U);
}

TEST(MendTool, ShowsWhatHasMovedApartAndLeavesIt) {
  const FoldedState apart =
      run("square 100; edge 50,0 50,100; tear 50,100 50,50; fold B valley 50,50 105,50 left facets "
          "75,50");
  ToolDriver hand(ToolId::Mend, apart);
  EXPECT_FALSE(hand.field("all").isEnabled);
  hand.hover({50, 80});
  EXPECT_GE(hand.count(MarkRole::Fault), 1U);
  EXPECT_EQ(hand.tool().cursor(hand.scope()), CursorShape::Forbidden);
  EXPECT_TRUE(failsWith(hand.result(), ErrorCode::CannotMend, "moved apart"));
  hand.click({50, 80});
  EXPECT_TRUE(hand.steps().empty());
}

TEST(MendTool, WithoutTearsThereIsNothingToDo) {
  ToolDriver hand(ToolId::Mend, kCross);
  hand.hover({50, 25});
  EXPECT_FALSE(hand.proposal());
  EXPECT_FALSE(hand.click({50, 25}).isHandled);
  EXPECT_TRUE(hand.tool().fields(hand.scope()).empty());
}

}  // namespace
}  // namespace kiri::test
