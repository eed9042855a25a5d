// The line tool, driven by events: drawn, typed, constructed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/model/apply.h"
#include "tests/editor/tools/images.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

FoldStep foldOf(const ToolDriver& hand) { return std::get<FoldStep>(hand.step().action); }

/// Distance of a point from the infinite line of the step.
double awayFrom(const FoldStep& step, Vec2 p) {
  return std::abs(cross(normalized(step.line.to - step.line.from), p - step.line.from));
}

enum Place : int {
  kThroughPoints = 1,
  kPointOntoPoint,
  kLineOntoLine,
  kSquareThrough,
  kPointOntoLine,
  kPointsOntoLines,
  kPointSquareTo,
  kBisector,
  kMirror,
  kProject
};

TEST(LineTool, DrawsAFoldLineOnPaperToo) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.drag({1, 99}, {99, 1});
  ASSERT_TRUE(hand.key(Key::Enter).wantsCommit);
  ASSERT_EQ(hand.state().pattern.facets.size(), 2U);
  const bool isLowerMoved = distance(imageOf(hand.state(), {0, 0}), {100, 100, 0}) < 1e-6;
  const bool isUpperMoved = distance(imageOf(hand.state(), {100, 100}), {0, 0, 0}) < 1e-6;
  EXPECT_TRUE(isLowerMoved != isUpperMoved);
}

TEST(LineTool, TwoClicksDrawALine) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.click({50, 1});
  EXPECT_FALSE(hand.proposal());
  hand.click({50, 99});
  ASSERT_TRUE(hand.proposal());
  EXPECT_TRUE(hand.proposal()->isComplete);
  EXPECT_NEAR(awayFrom(foldOf(hand), {50, 40}), 0, 1e-9);
}

TEST(LineTool, LengthAndDirectionCanBeTyped) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.drag({1, 1}, {60, 40});
  hand.set("direction", 30);
  EXPECT_NEAR(hand.field("direction").value, 30, 1e-9);
  const double slope = std::tan(30 * std::acos(-1.0) / 180);
  EXPECT_NEAR(awayFrom(foldOf(hand), {100, 100 * slope}), 0, 1e-6);
  hand.set("length", 42);
  EXPECT_NEAR(hand.field("length").value, 42, 1e-9);
  EXPECT_TRUE(hand.result());
}

TEST(LineTool, PointOntoPointPutsItThere) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.set("construct", kPointOntoPoint);
  hand.click({1, 1});
  hand.click({99, 50});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  const bool isMoved = distance(imageOf(*after, {0, 0}), {100, 50, 0}) < 1e-6;
  const bool isOther = distance(imageOf(*after, {100, 50}), {0, 0, 0}) < 1e-6;
  EXPECT_TRUE(isMoved || isOther);
}

TEST(LineTool, ThroughPointsGoesThroughBoth) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.set("construct", kThroughPoints);
  hand.click({1, 1});
  hand.click({99, 50});
  EXPECT_NEAR(awayFrom(foldOf(hand), {0, 0}), 0, 1e-9);
  EXPECT_NEAR(awayFrom(foldOf(hand), {100, 50}), 0, 1e-9);
}

TEST(LineTool, SpaceGoesThroughTheLinesThatLayAnEdgeOntoAnother) {
  ToolDriver hand(ToolId::Line, "square 100; edge 30,0 80,100; edge 0,60 100,40");
  hand.set("construct", kLineOntoLine);
  hand.click({37, 14});
  hand.click({15, 57});
  ASSERT_TRUE(hand.proposal());
  EXPECT_EQ(hand.field("solution").most, 2);
  const FoldStep first = foldOf(hand);
  hand.key(Key::Space);
  const FoldStep second = foldOf(hand);
  const Vec2 a = normalized(first.line.to - first.line.from);
  const Vec2 b = normalized(second.line.to - second.line.from);
  EXPECT_NEAR(dot(a, b), 0, 1e-9);  // the two bisectors are square to each other
  hand.key(Key::Space);
  EXPECT_EQ(textOf(Step{foldOf(hand), {}, {}, {}}), textOf(Step{first, {}, {}, {}}));
}

TEST(LineTool, SquareThroughAPointStandsSquareOnTheEdge) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.set("construct", kSquareThrough);
  hand.click({50, 99.5});
  hand.click({30, 0});
  const FoldStep step = foldOf(hand);
  EXPECT_NEAR(step.line.from.x, 50, 1e-9);
  EXPECT_NEAR(step.line.to.x, 50, 1e-9);
}

TEST(LineTool, APointIsLaidOntoALineThroughAPoint) {
  ToolDriver hand(ToolId::Line, "square 100; fold valley 50,0 50,100 to 0,50; unfold all");
  hand.set("construct", kPointOntoLine);
  hand.click({1, 1});    // the corner
  hand.click({50, 70});  // onto the middle crease
  hand.click({99, 1});   // through the other corner
  const auto proposal = hand.proposal();
  ASSERT_TRUE(proposal);
  EXPECT_NEAR(awayFrom(foldOf(hand), {100, 0}), 0, 1e-9);
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_NEAR(imageOf(*after, {0, 0}).x, 50, 1e-6);
}

TEST(LineTool, TheBisectorHalvesACorner) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.set("construct", kBisector);
  hand.click({99, 1});
  hand.click({1, 1});
  hand.click({1, 99});
  EXPECT_NEAR(awayFrom(foldOf(hand), {100, 100}), 0, 1e-9);
}

TEST(LineTool, APickedLineIsMirroredInTheSelectedOne) {  // thesis 4.5, F31
  ToolDriver hand(ToolId::Line,
                  "square 100; fold valley 20,0 40,100 to 0,50; unfold all; "
                  "fold valley 50,0 50,100 to 90,50; unfold all");
  const auto edgeAt = [&](Vec2 p) {
    std::size_t best = 0;
    for (std::size_t e = 0; e < hand.state().pattern.edges.size(); ++e) {
      if (nearestOn(arcOf(hand.state().pattern, EdgeId(e)), p).distance < 1e-6) best = e;
    }
    return EdgeId(best);
  };
  hand.selection.set({selectedLine(hand.state(), edgeAt({50, 30}))});
  hand.set("construct", kMirror);
  hand.click({30, 50});
  ASSERT_TRUE(hand.proposal());
  EXPECT_NEAR(awayFrom(foldOf(hand), {80, 0}), 0, 1e-6);
  EXPECT_NEAR(awayFrom(foldOf(hand), {60, 100}), 0, 1e-6);
}

TEST(LineTool, ADrawnLineIsLaidOntoTheNearestEdge) {  // thesis 4.5, F32
  ToolDriver hand(ToolId::Line, "square 100; fold valley 20,0 20,100 to 0,50; unfold all");
  hand.snaps.isOn = false;
  hand.set("construct", kProject);
  hand.drag({23, 10}, {22, 90});
  ASSERT_TRUE(hand.proposal());
  EXPECT_NEAR(foldOf(hand).line.from.x, 20, 1e-9);
  EXPECT_NEAR(foldOf(hand).line.to.x, 20, 1e-9);
}

TEST(LineTool, EscapeForgetsWhatWasPicked) {
  ToolDriver hand(ToolId::Line, "square 100");
  hand.set("construct", kPointOntoPoint);
  hand.click({1, 1});
  EXPECT_TRUE(hand.tool().isBusy());
  EXPECT_TRUE(hand.key(Key::Escape).isHandled);
  EXPECT_FALSE(hand.tool().isBusy());
  EXPECT_EQ(hand.count(MarkRole::Selected), 0U);
  hand.click({1, 1});
  EXPECT_FALSE(hand.proposal());
}

}  // namespace
}  // namespace kiri::test
