// The fold tool, driven by events: grab, draw, sides, what stays and what is dropped.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/editor/tools/images.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

const char* const kHalved = "square 100; fold valley 50,0 50,100 to 10,50";

TEST(FoldTool, ACornerIsGrabbedFromJustBesideThePaper) {
  ToolDriver hand(ToolId::Fold, "square 100");
  const double pixel = 1 / hand.camera.map().pixelsPerMm;
  hand.drag({100 + 3 * pixel, 100 + 2 * pixel}, {0, 0});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_AT(imageOf(*after, {100, 100}), 0, 0, 0);
  hand.key(Key::Escape);
  hand.drag({100 + 30 * pixel, 100 + 20 * pixel}, {-30, -20});  // farther away it is a line
  const auto along = hand.result();
  ASSERT_TRUE(along) << along.error().message;
  EXPECT_GT(distance(imageOf(*along, {100, 100}), Vec3{0, 0, 0}), 1);
}

TEST(FoldTool, DraggingACornerOntoAnotherFoldsTheDiagonal) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  ASSERT_TRUE(hand.proposal()->isComplete);
  EXPECT_TRUE(hand.key(Key::Enter).wantsCommit);
  const FoldedState& state = hand.state();
  ASSERT_EQ(state.pattern.facets.size(), 2U);
  EXPECT_AT(imageOf(state, {0, 0}), 100, 100, 0);
  EXPECT_AT(imageOf(state, {100, 0}), 100, 0, 0);
  EXPECT_AT(imageOf(state, {100, 100}), 100, 100, 0);
  EXPECT_TRUE(state.lines.front().isValley);
  EXPECT_FALSE(hand.tool().isBusy());
}

TEST(FoldTool, TheGrabbedPlaceComesToLieUnderThePointer) {
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    ToolDriver hand(ToolId::Fold, "square 100");
    hand.snaps.isOn = false;
    const Vec2 from{random.between(2, 98), random.between(2, 98)};
    const Vec2 to{random.between(-30, 130), random.between(-30, 130)};
    hand.drag(from, to);
    if (!hand.proposal()) continue;  // hardly moved
    const auto after = hand.result();
    if (!after) {
      EXPECT_EQ(after.error().code, ErrorCode::TooThin);
      continue;
    }
    EXPECT_AT(imageOf(*after, from), to.x, to.y, 0);
    EXPECT_LE(stretchOf(*after), after->tolerance().match());
  }
}

TEST(FoldTool, DraggingAnEdgeOntoTheOppositeEdgeFoldsInHalf) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({0.5, 50}, {99.5, 50});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_AT(imageOf(*after, {0, 0}), 100, 0, 0);
  EXPECT_AT(imageOf(*after, {0, 100}), 100, 100, 0);
}

TEST(FoldTool, TheCupIsFoldedByHandWithoutMeasuring) {  // Figure 7.16
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({99, 1}, {1, 99});
  hand.key(Key::Enter);
  // A corner that is dragged along the far edge is caught where its edge runs along the fold.
  hand.drag({0.5, 0.5}, {41, 99.5});
  hand.key(Key::Enter);
  const double part = 100 * (std::sqrt(2) - 1);
  EXPECT_AT(imageOf(hand.state(), {0, 0}), part, 100, 0);
  hand.drag({99.5, 99.5}, {0.5, 58});
  hand.key(Key::Enter);
  EXPECT_AT(imageOf(hand.state(), {100, 100}), 0, 100 - part, 0);
  hand.drag({0.5, 99.5}, {41, 59});
  hand.key(Key::Enter);
  EXPECT_AT(imageOf(hand.state(), {100, 0}), part, 100 - part, 0);
  EXPECT_TRUE(hand.state().collisions.empty()) << "its edges lie along the fold, not across it";
}

TEST(FoldTool, AnEdgeDraggedToANeighbourIsLaidAlongIt) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.snaps.toMidpoints = false;
  hand.drag({0.5, 31}, {31.6, 0.5});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_AT(imageOf(*after, {0, 100}), 100, 0, 0);
  EXPECT_AT(imageOf(*after, {0, 60}), 60, 0, 0);
}

TEST(FoldTool, FromBehindAValleyStillComesTowardsTheEye) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.look(Camera::Preset::Back);
  hand.drag({1, 1}, {99, 99});
  EXPECT_EQ(hand.field("type").value, 0);
  EXPECT_EQ(std::get<FoldStep>(hand.step().action).type, FoldType::Mountain);
  hand.set("angle", 90);
  const auto after = hand.result();
  ASSERT_TRUE(after);
  EXPECT_LT(imageOf(*after, {0, 0}).z, -60);
  hand.key('m');
  EXPECT_EQ(hand.field("type").value, 1);
  EXPECT_GT(imageOf(*hand.result(), {0, 0}).z, 60);
}

TEST(FoldTool, WalkingRoundTheModelDoesNotChangeTheFoldThatIsOffered) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  const std::string before = textOf(hand.step());
  hand.look(Camera::Preset::Back);
  EXPECT_EQ(textOf(hand.step()), before);
  EXPECT_EQ(hand.field("type").value, 1);  // what was a valley is seen from behind
}

TEST(FoldTool, ZoomAndOrbitDoNotChangeWhatIsMeant) {
  const auto folded = [](double zoom, double right, double up, Vec2 pan) {
    ToolDriver hand(ToolId::Fold, kHalved);
    hand.camera.turn(right, up);
    hand.camera.zoom({400, 300}, zoom);
    hand.camera.pan(pan);
    hand.drag({99.5, 0.5}, {50.5, 50});
    return textOf(hand.step());
  };
  const std::string plain = folded(1, 0, 0, {0, 0});
  EXPECT_EQ(folded(1.7, 0, 0, {30, -20}), plain);
  EXPECT_EQ(folded(1, 20, 30, {0, 0}), plain);
  EXPECT_EQ(folded(0.8, -35, 10, {-40, 10}), plain);
}

TEST(FoldTool, ACollisionIsMarkedAndTheFoldCanBeMadeAllTheSame) {
  ToolDriver hand(ToolId::Fold, "square 100; fold valley 30,0 30,100 to 10,50");
  hand.drag({50, 110}, {50, -10});
  hand.held.control = true;
  hand.click({85, 50});
  hand.click({55, 50});
  hand.held = {};
  hand.key('v');  // Q rises through P
  ASSERT_NE(hand.scope().preview, nullptr);
  EXPECT_FALSE(hand.scope().preview->collisions.empty()) << "the session marks it";
  EXPECT_TRUE(hand.key(Key::Enter).wantsCommit);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_FALSE(hand.state().collisions.empty());
}

TEST(FoldTool, ATypedAngleIsTheAngleOfTheFold) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  hand.set("angle", 90);
  hand.set("name", "diagonal");
  ASSERT_TRUE(hand.commit());
  ASSERT_EQ(hand.state().lines.size(), 1U);
  EXPECT_EQ(hand.state().lines[0].name, "diagonal");
  EXPECT_DOUBLE_EQ(amountOf(hand.state(), FoldLineId(0)).value(), 90);
  EXPECT_NEAR(imageOf(hand.state(), {0, 0}).z, std::sqrt(5000), 1e-9);
}

TEST(FoldTool, TabTurnsTheOtherSide) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({30, -10}, {30, 110});
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 60, 50, 0);  // the smaller side
  hand.key(Key::Tab);
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 0, 50, 0);
  EXPECT_AT(imageOf(*hand.result(), {100, 50}), -40, 50, 0);
  hand.push("side");
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 60, 50, 0);
}

TEST(FoldTool, TheDrawnLineStaysAndIsMovedByItsHandles) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.snaps.isOn = false;
  hand.drag({30, -10}, {30, 110});
  hand.drag({30, 110}, {60, 110});                          // its far end
  hand.drag({30, -10}, {60, -10});                          // its near end
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 120, 50, 0);  // still the side that moved before
  hand.drag({60, 50}, {20, 50});                            // the middle: in parallel
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 40, 50, 0);
}

TEST(FoldTool, AClickElsewhereKeepsTheProposalAndADragStartsAnew) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {40, 40});
  const std::string before = textOf(hand.step());
  hand.click({70, 30});
  EXPECT_EQ(textOf(hand.step()), before);
  hand.drag({99, 99}, {60, 60});
  EXPECT_NE(textOf(hand.step()), before);
  EXPECT_AT(imageOf(*hand.result(), {0, 0}), 0, 0, 0);
}

TEST(FoldTool, TheHeldCornerCanBeTakenAgain) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.snaps.isOn = false;
  hand.drag({2, 2}, {40, 40});
  hand.drag({40, 40}, {30, 60});
  EXPECT_AT(imageOf(*hand.result(), {2, 2}), 30, 60, 0);
}

TEST(FoldTool, ADoubleClickMakesTheFold) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  hand.click({50, 50});
  EXPECT_TRUE(hand.doubleClick({50, 50}).wantsCommit);
  EXPECT_EQ(hand.steps().size(), 1U);
}

TEST(FoldTool, EscapeAndResetLeaveNothing) {
  ToolDriver hand(ToolId::Fold, kHalved);
  for (const bool byKey : {true, false}) {
    hand.drag({99.5, 0.5}, {75, 25});
    ASSERT_TRUE(hand.proposal());
    if (byKey) {
      EXPECT_TRUE(hand.key(Key::Escape).isHandled);
    } else {
      hand.tool().reset();
    }
    EXPECT_FALSE(hand.proposal());
    EXPECT_FALSE(hand.tool().isBusy());
    EXPECT_TRUE(hand.tool().marks(hand.scope()).empty());
    EXPECT_TRUE(hand.tool().tints(hand.scope()).empty());
    EXPECT_TRUE(hand.tool().fields(hand.scope()).empty());
    EXPECT_FALSE(hand.key(Key::Escape).isHandled);
  }
}

TEST(FoldTool, WhileTheHandDrawsTheProposalIsNotComplete) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.press({1, 1});
  EXPECT_FALSE(hand.proposal());
  hand.moveTo({40, 40});
  ASSERT_TRUE(hand.proposal());
  EXPECT_FALSE(hand.proposal()->isComplete);
  EXPECT_FALSE(hand.key(Key::Enter).wantsCommit);
}

TEST(FoldTool, OnTheSheetALineFoldsTheFacetUnderItsMiddle) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.pane = Pane::Sheet;
  hand.drag({-5, 10}, {15, -10});  // across a corner of the left half, which lies on top
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 3U);
  EXPECT_AT(imageOf(*after, {0, 0}), 95, 5, 0);
}

TEST(FoldTool, OnTheSheetAValleyFoldsTheFrontsTogether) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.pane = Pane::Sheet;
  hand.drag({-5, 10}, {15, -10});
  EXPECT_EQ(hand.field("type").value, 0);
  const auto after = hand.result();
  ASSERT_TRUE(after);
  for (const Edge& edge : after->pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || edge.line != FoldLineId(1)) continue;
    EXPECT_EQ(edge.angle, 180);
  }
}

TEST(FoldTool, StepsNamePlacesOnThePaperOnly) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.drag({99.5, 0.5}, {75, 25});
  const auto step = std::get<FoldStep>(hand.step().action);
  EXPECT_EQ(step.line.frame, Frame::Paper);
  EXPECT_TRUE(step.line.facet.has_value());
  for (const Place& place : std::get<ChosenLayers>(step.layers).facets)
    EXPECT_EQ(place.frame, Frame::Paper);
  EXPECT_EQ(std::get<MovingPoint>(step.moving).place.frame, Frame::Paper);
}

TEST(FoldTool, AFlapDraggedBackOverItsCreaseOpensItsFold) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.drag({99.5, 0.5}, {0.5, 0.5});
  ASSERT_TRUE(hand.key(Key::Enter).wantsCommit);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_EQ(std::get<AngleStep>(hand.steps()[0].action).angle, 0);
  EXPECT_AT(imageOf(hand.state(), {0, 0}), 0, 0, 0);
  EXPECT_FALSE(hand.tool().isBusy());
}

TEST(FoldTool, HintsAndCursorsSayWhatTheHandCanDo) {
  ToolDriver hand(ToolId::Fold, "square 100");
  const Phrase idle = hand.tool().hint(hand.scope());
  hand.hover({50, 50});
  EXPECT_EQ(hand.tool().cursor(hand.scope()), CursorShape::Hand);
  hand.hover({-20, 50});
  EXPECT_EQ(hand.tool().cursor(hand.scope()), CursorShape::Cross);
  hand.press({1, 1});
  hand.moveTo({40, 40});
  EXPECT_EQ(hand.tool().cursor(hand.scope()), CursorShape::ClosedHand);
  const Phrase grabbing = hand.tool().hint(hand.scope());
  hand.release({40, 40});
  const Phrase resting = hand.tool().hint(hand.scope());
  EXPECT_FALSE(idle.isEmpty());
  EXPECT_NE(idle, grabbing);
  EXPECT_NE(grabbing, resting);
  EXPECT_GE(hand.count(MarkRole::Ghost), 1U);
  EXPECT_GE(hand.count(MarkRole::Handle), 3U);
  EXPECT_GE(hand.count(MarkRole::Valley), 2U);
}

}  // namespace
}  // namespace kiri::test
