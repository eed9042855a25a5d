// Opening creases, selecting and measuring, driven by events.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

const char* const kHalvedAtMid = "square 100; fold mid valley 50,0 50,100 to 10,50";

TEST(AngleTool, ACreaseThatIsPulledOpensItsFold) {
  ToolDriver hand(ToolId::Angle, kHalvedAtMid);
  hand.drag({50, 40}, {20, 40});
  ASSERT_TRUE(hand.proposal());
  const auto step = std::get<AngleStep>(hand.step().action);
  EXPECT_EQ(std::get<std::string>(step.line), "mid");
  EXPECT_LT(step.angle, 180);
  EXPECT_GT(step.angle, 0);
  EXPECT_TRUE(hand.key(Key::Enter).wantsCommit);
  EXPECT_DOUBLE_EQ(amountOf(hand.state(), FoldLineId(0)).value(), step.angle);
}

TEST(AngleTool, PulledFarEnoughTheFoldLiesFlat) {
  ToolDriver hand(ToolId::Angle, kHalvedAtMid);
  hand.drag({50, 40}, {-40, 40});
  EXPECT_EQ(std::get<AngleStep>(hand.step().action).angle, 0);
}

TEST(AngleTool, TheAngleCanBeTypedAndStepped) {
  ToolDriver hand(ToolId::Angle, kHalvedAtMid);
  hand.click({50, 40});
  EXPECT_FALSE(hand.proposal());  // as it is
  hand.set("angle", 72.5);
  EXPECT_EQ(std::get<AngleStep>(hand.step().action).angle, 72.5);
  hand.key(Key::Up);
  EXPECT_EQ(hand.field("angle").value, 87.5);
  EXPECT_TRUE(hand.commit());
}

TEST(AngleTool, ACreaseUnderThePointerLightsUp) {
  ToolDriver hand(ToolId::Angle, kHalvedAtMid);
  hand.hover({80, 40});
  EXPECT_EQ(hand.count(MarkRole::Hovered), 0U);
  hand.hover({50, 40});
  EXPECT_GE(hand.count(MarkRole::Hovered), 1U);
  EXPECT_FALSE(hand.press({80, 40}).isHandled);  // the pane may orbit
}

TEST(AngleTool, EscapeLeavesTheFoldAsItIs) {
  ToolDriver hand(ToolId::Angle, kHalvedAtMid);
  hand.drag({50, 40}, {20, 40});
  EXPECT_TRUE(hand.key(Key::Escape).isHandled);
  EXPECT_FALSE(hand.proposal());
  EXPECT_FALSE(hand.tool().isBusy());
}

TEST(AngleTool, FromBehindItPullsTheSameWay) {
  ToolDriver hand(ToolId::Angle, kHalvedAtMid);
  hand.look(Camera::Preset::Back);
  hand.drag({50, 40}, {-40, 40});
  EXPECT_EQ(std::get<AngleStep>(hand.step().action).angle, 0);
}

TEST(SelectTool, AClickPicksTheFacetThatIsSeenAndShiftAdds) {
  ToolDriver hand(ToolId::Select, "square 100; fold valley 30,0 30,100 to 10,50");
  hand.click({45, 50});  // the flap
  ASSERT_EQ(hand.selection.items().size(), 1U);
  EXPECT_LT(hand.selection.items()[0].place.x, 30);
  hand.held.shift = true;
  hand.click({80, 50});
  EXPECT_EQ(hand.selection.items().size(), 2U);
  hand.click({45, 50});
  EXPECT_EQ(hand.selection.items().size(), 1U);
  hand.held = {};
  hand.click({300, 50});
  EXPECT_TRUE(hand.selection.isEmpty());
}

TEST(SelectTool, ARectanglePicksFacets) {
  ToolDriver hand(ToolId::Select, "square 100; fold valley 30,0 30,100 to 10,50; unfold all");
  hand.drag({-5, -5}, {35, 105});
  ASSERT_EQ(hand.selection.items().size(), 1U);
  EXPECT_LT(hand.selection.items()[0].place.x, 30);
  hand.drag({-5, -5}, {105, 105});
  EXPECT_EQ(hand.selection.items().size(), 2U);
}

TEST(SelectTool, EachKindPicksItsOwn) {
  ToolDriver hand(ToolId::Select, "square 100");
  const auto picks = [&](SelectedKind kind, Vec2 at) {
    hand.set("kind", static_cast<double>(kind));
    hand.click(at);
    EXPECT_EQ(hand.selection.items().size(), 1U);
    return hand.selection.isEmpty() ? Selected{} : hand.selection.items()[0];
  };
  EXPECT_EQ(picks(SelectedKind::Vertex, {1, 99}).place, (Vec2{0, 100}));
  const Selected line = picks(SelectedKind::Line, {60, 0.5});
  EXPECT_EQ(line.kind, SelectedKind::Line);
  EXPECT_NEAR(line.from.y + line.to.y, 0, 1e-9);
  const Selected point = picks(SelectedKind::Point, {20, 70});
  EXPECT_EQ(point.kind, SelectedKind::Point);
  EXPECT_NEAR(point.place.x, 20, 0.3);
  EXPECT_EQ(picks(SelectedKind::Inside, {20, 70}).kind, SelectedKind::Inside);
}

TEST(SelectTool, EscapeClears) {
  ToolDriver hand(ToolId::Select, "square 100");
  hand.click({50, 50});
  EXPECT_FALSE(hand.tool().tints(hand.scope()).empty());
  EXPECT_TRUE(hand.key(Key::Escape).isHandled);
  EXPECT_TRUE(hand.selection.isEmpty());
  EXPECT_FALSE(hand.key(Key::Escape).isHandled);
}

TEST(MeasureTool, ADistanceIsToldOnTheSheetAndInSpace) {
  ToolDriver hand(ToolId::Measure, "square 100; fold valley 90 50,0 50,100 to 10,50");
  hand.pane = Pane::Sheet;
  hand.click({1, 1});
  hand.click({99, 1});
  EXPECT_DOUBLE_EQ(hand.field("paper").value, 100);
  EXPECT_NEAR(hand.field("space").value, 50 * std::sqrt(2), 1e-9);
  EXPECT_FALSE(hand.field("paper").isEnabled);
  EXPECT_GE(hand.count(MarkRole::Measure), 4U);
  EXPECT_TRUE(hand.key(Key::Escape).isHandled);
  EXPECT_FALSE(hand.hasField("paper"));
  EXPECT_EQ(hand.count(MarkRole::Measure), 0U);
}

TEST(MeasureTool, ThreePointsMakeAnAngle) {
  ToolDriver hand(ToolId::Measure, "square 100");
  hand.set("what", 1);
  hand.click({99, 1});
  hand.click({1, 1});
  hand.click({99, 99});
  EXPECT_NEAR(hand.field("angle").value, 45, 1e-9);
}

TEST(MeasureTool, EdgesHaveALengthAndFacetsAnArea) {
  ToolDriver hand(ToolId::Measure, "rectangle 80 60; fold valley 30,0 30,60 to 0,30; unfold all");
  hand.set("what", 2);
  hand.click({30, 25});
  EXPECT_DOUBLE_EQ(hand.field("length").value, 60);
  EXPECT_DOUBLE_EQ(hand.field("hinge").value, 0);
  hand.set("what", 3);
  hand.click({60, 30});
  EXPECT_NEAR(hand.field("area").value, 3000, 1e-9);
}

}  // namespace
}  // namespace kiri::test
