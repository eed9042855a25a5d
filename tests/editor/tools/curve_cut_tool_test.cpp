// Cutting along curves by hand.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/editor/tools/examples.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

CurveCutStep curveOf(const Step& step) { return std::get<CurveCutStep>(step.action); }

/// A curve cut tool on a state, with snapping switched off.
ToolDriver handOn(const FoldedState& state) {
  ToolDriver hand(ToolId::CurveCut, state);
  hand.snaps.isOn = false;
  return hand;
}

void clickAll(ToolDriver& hand, const std::vector<Vec2>& places) {
  for (const Vec2 p : places) hand.click(p);
}

constexpr std::size_t kPalmateCut = 14;

TEST(CurveCutTool, ThePalmateLeafComesOutAsInTheExample) {
  const Example leaf = exampleOf("leaf_palmate");
  ToolDriver hand = handOn(leaf.after(kPalmateCut - 1));
  clickAll(hand, curveOf(leaf.step(kPalmateCut)).controls);
  ASSERT_TRUE(hand.proposal());
  EXPECT_FALSE(hand.proposal()->isComplete);
  hand.key(Key::Enter);
  ASSERT_TRUE(hand.proposal()->isComplete);
  hand.key(Key::Enter);
  ASSERT_EQ(hand.steps().size(), 1U);

  const FoldedState& cut = leaf.after(kPalmateCut);
  EXPECT_NEAR(areaOf(hand.state()), areaOf(cut), 1e-6);
  EXPECT_EQ(facetCount(hand.state()), facetCount(cut));
  EXPECT_LT(rimGap(hand.state(), cut), 1e-9);
  EXPECT_TRUE(isSound(hand.state()));

  const auto open = apply(hand.state(), leaf.step(kPalmateCut + 1), 15);
  ASSERT_TRUE(open);
  EXPECT_NEAR(areaOf(*open), areaOf(leaf.after(kPalmateCut + 1)), 1e-6);
  EXPECT_LT(rimGap(*open, leaf.after(kPalmateCut + 1)), 1e-9);
}

TEST(CurveCutTool, TypedCoordinatesAreThoseOfTheModelSeenFromTheFront) {
  const Example leaf = exampleOf("leaf_palmate");
  ToolDriver hand = handOn(leaf.after(kPalmateCut - 1));
  for (const Vec2 p : curveOf(leaf.step(kPalmateCut)).controls) {
    hand.click(p + Vec2{2.5, -1.5});
    hand.set("x", p.x);
    hand.set("y", p.y);
    EXPECT_NEAR(hand.field("x").value, p.x, 1e-9);
    EXPECT_NEAR(hand.field("y").value, p.y, 1e-9);
  }
  hand.key(Key::Enter);
  hand.key(Key::Enter);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_LT(rimGap(hand.state(), leaf.after(kPalmateCut)), 1e-9);
}

TEST(CurveCutTool, FromTheBackTheSameClicksMeanTheSameCut) {
  const Example leaf = exampleOf("leaf_palmate");
  ToolDriver hand = handOn(leaf.after(kPalmateCut - 1));
  hand.look(Camera::Preset::Back);
  clickAll(hand, curveOf(leaf.step(kPalmateCut)).controls);
  hand.key(Key::Enter);
  hand.key(Key::Enter);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_NEAR(areaOf(hand.state()), areaOf(leaf.after(kPalmateCut)), 1e-6);
  EXPECT_LT(rimGap(hand.state(), leaf.after(kPalmateCut)), 1e-9);
}

TEST(CurveCutTool, WhatStaysWithoutAWordIsWhatTheExamplesKeep) {
  for (const char* name :
       {"kirigami_flower", "kirigami_snowflake", "kirigami_star", "leaf_hornbeam", "leaf_palmate",
        "leaf_petiole_inside", "leaf_secondary_lobes", "leaf_three_lobes"}) {
    const Example example = exampleOf(name);
    for (std::size_t number = 1; number <= example.model.steps.size(); ++number) {
      const auto* cut = std::get_if<CurveCutStep>(&example.step(number).action);
      if (!cut) continue;
      SCOPED_TRACE(std::string(name) + " step " + std::to_string(number));
      ToolDriver hand = handOn(example.after(number - 1));
      for (const Vec2 p : cut->controls) {
        hand.camera.zoom(hand.pixels(p), 2);  // as a person does where points are near each other
        hand.click(p);
        hand.camera.zoom(hand.pixels(p), 0.5);
      }
      if (cut->isClosed) hand.set("closed", 1);
      hand.key(Key::Enter);
      hand.key(Key::Enter);
      ASSERT_EQ(hand.steps().size(), 1U);
      EXPECT_NEAR(areaOf(hand.state()), areaOf(example.after(number)), 1e-6);
      EXPECT_LT(rimGap(hand.state(), example.after(number)), 1e-6);
    }
  }
}

// A square, and a curve that parts it: 100 x 100, from (30, -10) to (30, 110).
const std::vector<Vec2> kWave{{30, -10}, {45, 30}, {15, 70}, {30, 110}};

ToolDriver waved() {
  ToolDriver hand = handOn(run("square 100"));
  clickAll(hand, kWave);
  hand.key(Key::Enter);
  return hand;
}

TEST(CurveCutTool, AClickOnAPieceKeepsOrDropsItAndTheLastOneChangesPlaces) {
  ToolDriver hand = waved();
  const double first = hand.areaAfter();
  EXPECT_NEAR(first, 3000, 400);  // less of the rim than the other
  hand.click({80, 50});           // the other one, too
  EXPECT_NEAR(hand.areaAfter(), 10000, 1e-6);
  hand.click({15, 20});
  EXPECT_NEAR(hand.areaAfter(), 10000 - first, 1e-6);
  hand.click({80, 50});  // what is left cannot go: the rest stays instead
  EXPECT_NEAR(hand.areaAfter(), first, 1e-6);
  hand.set("keep", 1);
  EXPECT_NEAR(hand.areaAfter(), 10000, 1e-6);
  hand.set("keep", 0);
  EXPECT_NEAR(hand.areaAfter(), first, 1e-6);
}

TEST(CurveCutTool, WhatGoesIsOutlinedWhereItWas) {
  ToolDriver hand = waved();
  EXPECT_GE(hand.count(MarkRole::Ghost), 4U);
  for (const Mark& mark : hand.tool().marks(hand.scope())) {
    const auto* path = std::get_if<PathMark>(&mark);
    if (!path || path->role != MarkRole::Ghost) continue;
    for (const MarkPlace& place : path->places) EXPECT_GT(std::get<Vec3>(place).x, 20);
  }
  hand.set("keep", 1);
  EXPECT_EQ(hand.count(MarkRole::Ghost), 0U);
}

TEST(CurveCutTool, ACutWithoutSidesStillKeepsAPiece) {
  // Downwards through the strip, round its end, and downwards again: the middle is on both sides.
  ToolDriver hand = handOn(run("polygon 0,0 120,0 120,20 0,20"));
  hand.camera.zoom({400, 300}, 0.4);
  clickAll(hand, {{40, 60},
                  {40, 30},
                  {40, -10},
                  {45, -50},
                  {100, -60},
                  {160, -50},
                  {175, 0},
                  {160, 60},
                  {120, 85},
                  {85, 65},
                  {80, 30},
                  {80, 5},
                  {80, -25}});
  hand.key(Key::Enter);
  EXPECT_EQ(hand.field("keep").value, 2);
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(pieceCount(*after), 1U);
  EXPECT_NEAR(areaOf(*after), 800, 100);
}

TEST(CurveCutTool, TheMarkOfWhatStaysCanBeDraggedAcross) {
  ToolDriver hand = waved();
  const double first = hand.areaAfter();
  Vec2 mark;
  for (const Mark& m : hand.tool().marks(hand.scope())) {
    const auto* text = std::get_if<TextMark>(&m);
    if (text) mark = std::get<Spot>(text->at).paper;
  }
  hand.drag(mark, {80, 40});
  EXPECT_NEAR(hand.areaAfter(), 10000 - first, 1e-6);
}

TEST(CurveCutTool, ControlsStayEditableUntilTheCutIsMade) {
  ToolDriver hand = waved();
  hand.drag(kWave[1], {60, 30});
  EXPECT_LT(distance(curveOf(hand.step()).controls[1], {60, 30}), 1e-9);
  hand.doubleClick(pointAt(openSpline(curveOf(hand.step()).controls, SplineEnds::Clamped)[0], 0.5));
  EXPECT_EQ(curveOf(hand.step()).controls.size(), 5U);
  hand.key(Key::Delete);
  EXPECT_EQ(curveOf(hand.step()).controls.size(), 4U);
  hand.key(Key::Delete);  // four are the fewest
  EXPECT_EQ(curveOf(hand.step()).controls.size(), 4U);
  hand.hover(pointAt(openSpline(curveOf(hand.step()).controls, SplineEnds::Clamped)[0], 0.4));
  hand.key(Key::Insert);
  EXPECT_EQ(curveOf(hand.step()).controls.size(), 5U);
  hand.key(Key::Right);  // the new one is active
  EXPECT_TRUE(hand.commit());
  EXPECT_FALSE(hand.tool().isBusy());
}

TEST(CurveCutTool, BackspaceTakesTheLastPointBackAndEscapeAll) {
  ToolDriver hand = handOn(run("square 100"));
  clickAll(hand, {{30, -10}, {45, 30}, {80, 80}});
  hand.key(Key::Backspace);
  hand.hover({45, 30});
  clickAll(hand, {{15, 70}, {30, 110}});
  hand.key(Key::Enter);
  const std::vector<Vec2> controls = curveOf(hand.step()).controls;
  ASSERT_EQ(controls.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(distance(controls[i], kWave[i]), 1e-9);
  EXPECT_TRUE(hand.key(Key::Escape).isHandled);
  EXPECT_FALSE(hand.proposal());
  EXPECT_FALSE(hand.key(Key::Escape).isHandled);
}

TEST(CurveCutTool, ThePreviewBeginsWithTheSecondPoint) {
  ToolDriver hand = handOn(run("square 100"));
  hand.click({-10, 50});
  EXPECT_FALSE(hand.proposal());
  hand.hover({110, 60});
  ASSERT_TRUE(hand.proposal());
  EXPECT_FALSE(hand.proposal()->isComplete);
  const auto after = hand.result();
  ASSERT_TRUE(after);
  EXPECT_EQ(pieceCount(*after), 2U);
  EXPECT_NEAR(areaOf(*after), 10000, 1e-6);
}

TEST(CurveCutTool, AClickOnTheStartClosesAWindowWhichFallsOut) {
  ToolDriver hand = handOn(run("square 100"));
  clickAll(hand, {{40, 40}, {60, 40}, {60, 60}, {40, 60}, {40, 40}});
  const CurveCutStep step = curveOf(hand.step());
  EXPECT_TRUE(step.isClosed);
  EXPECT_EQ(step.controls.size(), 4U);
  const double area = hand.areaAfter();
  EXPECT_LT(area, 10000 - 100);
  EXPECT_GT(area, 10000 - 400);
  hand.click({50, 50});
  EXPECT_NEAR(hand.areaAfter(), 10000, 1e-6);
}

TEST(CurveCutTool, ASlitPartsNothingAndKeepsEverything) {
  ToolDriver hand = handOn(run("square 100"));
  clickAll(hand, {{-10, 50}, {10, 60}, {30, 40}, {50, 50}});
  hand.key(Key::Enter);
  const auto after = hand.result();
  ASSERT_TRUE(after);
  EXPECT_NEAR(areaOf(*after), 10000, 1e-6);
  EXPECT_GE(edgeCount(*after, EdgeKind::Cut), 1U);
}

TEST(CurveCutTool, ACurveThatCrossesItselfIsRefusedByTheKernel) {
  ToolDriver hand = handOn(run("square 100"));
  clickAll(hand, {{10, 10}, {90, 90}, {160, 50}, {90, 10}, {10, 90}});
  hand.key(Key::Enter);
  EXPECT_TRUE(failsWith(hand.result(), ErrorCode::CurveCrossesItself, "crosses itself"));
  EXPECT_FALSE(hand.commit());
  EXPECT_NEAR(areaOf(hand.state()), 10000, 1e-9);
}

TEST(CurveCutTool, AFreehandStrokeOfAKnownSplineComesBack) {
  const std::vector<Arc> known = openSpline(kWave, SplineEnds::Clamped);
  ToolDriver hand = handOn(run("square 100"));
  hand.press(known.front().start);
  for (const Arc& arc : known) {
    for (int i = 1; i <= 60; ++i) hand.moveTo(pointAt(arc, i / 60.0));
  }
  ASSERT_TRUE(hand.proposal());
  EXPECT_FALSE(hand.proposal()->isComplete);
  hand.release(known.back().end);
  const CurveCutStep step = curveOf(hand.step());
  EXPECT_FALSE(step.isClosed);
  EXPECT_LE(step.controls.size(), 6U);
  const double pixel = 1 / hand.scope().model.pixelsPerMm;
  const FoldedState byHand = *hand.result();
  const FoldedState exact = after(run("square 100"), "curve 30,-10 45,30 15,70 30,110 keep 10,20");
  EXPECT_LT(rimGap(byHand, exact), 2 * pixel);
}

TEST(CurveCutTool, AStrokeThatComesBackToItsStartIsClosed) {
  ToolDriver hand = handOn(run("square 100"));
  const auto at = [](double turn) {
    return Vec2{50 + 25 * std::cos(turn), 50 + 15 * std::sin(turn)};
  };
  hand.press(at(0));
  for (int i = 1; i <= 90; ++i) hand.moveTo(at(6.2832 * i / 90));
  hand.release(at(6.2832));
  EXPECT_TRUE(curveOf(hand.step()).isClosed);
  EXPECT_NEAR(hand.areaAfter(), 10000 - 3.14159 * 25 * 15, 40);
}

TEST(CurveCutTool, OnlyTheUppermostLayerIsCutWhenTheWheelSaysSo) {
  const FoldedState folded = run("square 100; fold A valley 50,0 50,100 left");
  for (const Camera::Preset side : {Camera::Preset::Front, Camera::Preset::Back}) {
    ToolDriver hand = handOn(folded);
    hand.look(side);
    clickAll(hand, {{60, 20}, {80, 20}, {80, 40}, {60, 40}, {60, 20}});
    hand.held.control = true;
    hand.wheel({70, 30}, -1);
    hand.held.control = false;
    EXPECT_EQ(hand.field("count").value, 1);
    const auto after = hand.result();
    ASSERT_TRUE(after);
    const double hole = 10000 - areaOf(*after);
    EXPECT_GT(hole, 100);
    EXPECT_LT(hole, 400);
    const bool isLeftHoled = !facetAt(after->pattern, {30, 30});
    EXPECT_EQ(isLeftHoled, side == Camera::Preset::Front);
    EXPECT_EQ(!facetAt(after->pattern, {70, 30}), side == Camera::Preset::Back);
    hand.held.control = true;
    hand.wheel({70, 30}, 1);
    hand.held.control = false;
    EXPECT_NEAR(10000 - hand.areaAfter(), 2 * hole, 1e-6);
  }
}

TEST(CurveCutTool, OnTheSheetOfAFoldedModelOnlyWhatIsDrawnOnIsCut) {
  ToolDriver hand = handOn(run("square 100; fold A valley 50,0 50,100 left"));
  hand.pane = Pane::Sheet;
  clickAll(hand, {{60, 20}, {80, 20}, {80, 40}, {60, 40}, {60, 20}});
  const auto after = hand.result();
  ASSERT_TRUE(after);
  EXPECT_FALSE(facetAt(after->pattern, {70, 30}));
  EXPECT_TRUE(facetAt(after->pattern, {30, 30}));
}

TEST(CurveCutTool, AHalfFoldedModelIsCutStraightThroughWhenAsked) {
  ToolDriver hand = handOn(run("square 100; fold A valley 60 50,0 50,100 left"));
  EXPECT_FALSE(hand.hasField("layers"));
  clickAll(hand, {{20, 30}, {110, 20}, {110, 60}, {20, 50}});
  hand.key(Key::Enter);
  hand.set("layers", 2);
  const CurveCutStep step = curveOf(hand.step());
  EXPECT_EQ(step.frame, Frame::Model);
  EXPECT_TRUE(std::holds_alternative<ThroughAll>(step.layers));
  const auto after = hand.result();
  ASSERT_TRUE(after);
  EXPECT_LT(areaOf(*after), 10000 - 1000);
  hand.set("keep", 1);
  // The half that stands at 60 degrees is cut where it lies under the eye of the front.
  const auto whole = hand.result();
  ASSERT_TRUE(whole);
  EXPECT_EQ(pieceCount(*whole), 2U);
  bool isSlopeCut = false;
  for (const Edge& edge : whole->pattern.edges)
    isSlopeCut |= edge.kind == EdgeKind::Cut && whole->pattern[edge.from].x < 49;
  EXPECT_TRUE(isSlopeCut);
}

TEST(CurveCutTool, SnapsCatchCornersAndShowIt) {
  ToolDriver hand(ToolId::CurveCut, "square 100");
  hand.hover({101, 99});
  hand.press({101, 99});
  hand.release({101, 99});
  hand.click({60, 70});
  hand.hover({40, 20});
  ASSERT_TRUE(hand.proposal());
  EXPECT_EQ(curveOf(hand.step()).controls.front(), (Vec2{100, 100}));
}

TEST(CurveCutTool, AStateWithoutItsPaperDropsTheCurveInsteadOfFailing) {
  ToolDriver hand = waved();
  ASSERT_TRUE(hand.proposal());
  ToolDriver other = handOn(run("polygon 300,300 400,300 400,400"));
  EXPECT_FALSE(hand.tool().proposal(other.scope()));
  EXPECT_TRUE(hand.tool().marks(other.scope()).empty() || !hand.tool().proposal(other.scope()));
  hand.tool().pointer({PointerAction::Move, Pane::Model, {5, 5}, PointerButton::None, {}, false},
                      other.scope());
}

}  // namespace
}  // namespace kiri::test
