// Cutting along straight lines, and adding edges, by hand.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/editor/tools/examples.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

ToolDriver handOn(ToolId tool, const FoldedState& state) {
  ToolDriver hand(tool, state);
  hand.snaps.isOn = false;
  return hand;
}

TEST(StraightCutTool, FoldCutFoldComesOutAsInTheExample) {
  const Example example = exampleOf("straight_cut");
  ToolDriver hand = handOn(ToolId::StraightCut, example.after(1));
  hand.drag({-20, 70}, {60, 40});
  ASSERT_TRUE(hand.proposal());
  EXPECT_TRUE(hand.proposal()->isComplete);
  // The parts are nearly equal; the smaller of them is what the example keeps.
  EXPECT_NEAR(hand.areaAfter(), 10000 - areaOf(example.after(2)), 1e-6);
  hand.click({30, 90});
  EXPECT_NEAR(hand.areaAfter(), areaOf(example.after(2)), 1e-6);
  hand.key(Key::Enter);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_LT(rimGap(hand.state(), example.after(2)), 1e-9);
  const auto end = apply(hand.state(), example.step(3), 3);
  ASSERT_TRUE(end);
  EXPECT_TRUE(isSound(*end));
  EXPECT_NEAR(areaOf(*end), areaOf(example.after(3)), 1e-6);
  EXPECT_EQ(facetCount(*end), facetCount(example.after(3)));
}

TEST(StraightCutTool, TwoClicksAndADragMeanTheSameFromFrontAndBack) {
  const FoldedState folded = run("square 100; fold A valley 60,0 60,100 right");
  std::vector<double> areas;
  for (const Camera::Preset side : {Camera::Preset::Front, Camera::Preset::Back}) {
    ToolDriver dragged = handOn(ToolId::StraightCut, folded);
    dragged.look(side);
    dragged.drag({-20, 80}, {70, 70});
    ToolDriver clicked = handOn(ToolId::StraightCut, folded);
    clicked.look(side);
    clicked.click({-20, 80});
    clicked.click({70, 70});
    EXPECT_NEAR(dragged.areaAfter(), clicked.areaAfter(), 1e-9);
    areas.push_back(dragged.areaAfter());
  }
  EXPECT_NEAR(areas[0], areas[1], 1e-9);
  EXPECT_LT(areas[0], 9000);
  EXPECT_GT(areas[0], 5000);
}

TEST(StraightCutTool, WhatTheExamplesTrimIsTrimmedWithoutAWord) {
  for (const char* name : {"kirigami_star", "leaf_petiole_inside", "kirigami_snowflake"}) {
    const Example example = exampleOf(name);
    for (std::size_t number = 1; number <= example.model.steps.size(); ++number) {
      const auto* cut = std::get_if<StraightCutStep>(&example.step(number).action);
      if (!cut) continue;
      SCOPED_TRACE(name);
      ToolDriver hand = handOn(ToolId::StraightCut, example.after(number - 1));
      hand.drag(cut->line.from, cut->line.to);
      hand.key(Key::Enter);
      ASSERT_EQ(hand.steps().size(), 1U);
      EXPECT_NEAR(areaOf(hand.state()), areaOf(example.after(number)), 1e-6);
    }
  }
}

TEST(StraightCutTool, ADragOnThePaperIsAnotherCutAndAClickIsAPiece) {
  ToolDriver hand = handOn(ToolId::StraightCut, run("square 100"));
  hand.drag({-10, 30}, {110, 30});
  EXPECT_NEAR(hand.areaAfter(), 7000, 1e-6);
  hand.click({50, 10});
  EXPECT_NEAR(hand.areaAfter(), 10000, 1e-6);
  hand.drag({20, 90}, {20, -10});
  const auto step = std::get<StraightCutStep>(hand.step().action);
  EXPECT_NEAR(step.line.from.x, 20, 1e-9);
  EXPECT_NEAR(hand.areaAfter(), 10000, 1e-6);  // a slit: it does not reach the upper border
  hand.drag({20, -10}, {20, -30});             // the handle of its end
  hand.drag({20, 90}, {20, 130});              // and of its start
  EXPECT_NEAR(hand.areaAfter(), 8000, 1e-6);
}

TEST(StraightCutTool, LengthAndDirectionCanBeTyped) {
  ToolDriver hand = handOn(ToolId::StraightCut, run("square 100"));
  hand.drag({0, 30}, {90, 42});
  hand.set("direction", 0);
  hand.set("length", 120);
  const auto step = std::get<StraightCutStep>(hand.step().action);
  EXPECT_NEAR(step.line.to.x - step.line.from.x, 120, 1e-9);
  EXPECT_NEAR(step.line.to.y, step.line.from.y, 1e-9);
  EXPECT_NEAR(hand.areaAfter(), 7000, 1e-6);
}

TEST(StraightCutTool, GoesStraightThroughAHalfFoldedModel) {
  ToolDriver hand =
      handOn(ToolId::StraightCut, run("square 100; fold A valley 60 50,0 50,100 left"));
  hand.drag({20, 50}, {120, 50});
  hand.set("layers", 2);
  const auto after = hand.result();
  ASSERT_TRUE(after);
  EXPECT_EQ(pieceCount(*after), 1U);
  EXPECT_NEAR(areaOf(*after), 5000, 1e-6);
}

TEST(AddEdgeTool, DividesTheLayersItIsDrawnOver) {
  const FoldedState folded = run("square 100; fold A valley 50,0 50,100 left");
  ToolDriver hand = handOn(ToolId::AddEdge, folded);
  hand.drag({40, 50}, {110, 50});
  ASSERT_TRUE(hand.proposal()->isComplete);
  EXPECT_EQ(facetCount(*hand.result()), 4U);
  hand.held.control = true;
  hand.wheel({70, 50}, -1);
  hand.held.control = false;
  EXPECT_EQ(facetCount(*hand.result()), 3U);
  hand.key(Key::Enter);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_TRUE(isSound(hand.state()));
  // Seen from the front the left half lies on top.
  EXPECT_NE(facetAt(hand.state().pattern, {20, 20}), facetAt(hand.state().pattern, {20, 80}));
  EXPECT_EQ(facetAt(hand.state().pattern, {80, 20}), facetAt(hand.state().pattern, {80, 80}));
}

TEST(AddEdgeTool, PutsItsEndsOntoTheNearestEdges) {
  ToolDriver hand = handOn(ToolId::AddEdge, run("square 100"));
  hand.drag({5, 33}, {92, 61});
  hand.push("project");
  const DrawnLine line = std::get<AddEdgeStep>(hand.step().action).line;
  EXPECT_LT(distance(line.from, {0, 33}), 1e-9);
  EXPECT_LT(distance(line.to, {100, 61}), 1e-9);
  EXPECT_EQ(facetCount(*hand.result()), 2U);
}

TEST(AddEdgeTool, ShowsHowFarTheEdgeGoesBeyondWhatIsDrawn) {
  ToolDriver hand = handOn(ToolId::AddEdge, run("square 100"));
  hand.drag({20, 50}, {60, 50});
  EXPECT_EQ(hand.count(MarkRole::Possible), 2U) << "from both ends to the borders";
  const Phrase beyond = hand.tool().hint(hand.scope());
  hand.key(Key::Escape);
  hand.drag({-5, 50}, {105, 50});
  EXPECT_EQ(hand.count(MarkRole::Possible), 0U);
  EXPECT_NE(hand.tool().hint(hand.scope()), beyond);

  ToolDriver layered = handOn(ToolId::AddEdge, run("square 100; fold A valley 50,0 50,100 left"));
  layered.drag({70, 50}, {110, 50});
  EXPECT_EQ(layered.count(MarkRole::Possible), 2U) << "in both layers, from one end to the fold";
}

TEST(AddEdgeTool, SnapsToCorners) {
  ToolDriver hand(ToolId::AddEdge, "square 100");
  hand.drag({1, 1}, {99, 98.5});
  const DrawnLine line = std::get<AddEdgeStep>(hand.step().action).line;
  EXPECT_EQ(line.from, (Vec2{0, 0}));
  EXPECT_EQ(line.to, (Vec2{100, 100}));
}

TEST(AddEdgeTool, EscapeDropsTheLine) {
  ToolDriver hand = handOn(ToolId::AddEdge, run("square 100"));
  hand.drag({5, 33}, {92, 61});
  EXPECT_TRUE(hand.key(Key::Escape).isHandled);
  EXPECT_FALSE(hand.proposal());
  EXPECT_FALSE(hand.key(Key::Escape).isHandled);
  EXPECT_FALSE(hand.key(Key::Enter).isHandled);
}

}  // namespace
}  // namespace kiri::test
