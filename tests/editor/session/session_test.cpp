// A session as a person uses it, without a window.
// SPDX-License-Identifier: MIT
#include "editor/session/session.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "editor/session/moved_facets.h"
#include "io/kiri_writer.h"
#include "tests/editor/base/hand_runner.h"
#include "tests/editor/session/hand.h"
#include "tests/support/expect.h"
#include "tests/support/state_check.h"

namespace kiri {
namespace {

using test::Hand;

TEST(Session, ADraggedCornerIsFoldedOnEnterAndShownBefore) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  hand.drag({100, 100}, {0, 0});
  EXPECT_EQ(hand.stepCount(), 0u) << "nothing is done before Enter";
  const Shown shown = hand.session.shown();
  EXPECT_TRUE(shown.isPreview);
  EXPECT_EQ(shown.state->pattern.facets.size(), 2u);
  EXPECT_EQ(shown.base->pattern.facets.size(), 1u);
  EXPECT_EQ(hand.tinted(FacetTint::Pale), 1u) << "the half that has moved";
  EXPECT_TRUE(hand.key(Key::Enter));
  ASSERT_EQ(hand.stepCount(), 1u);
  EXPECT_FALSE(hand.session.shown().isPreview);
  EXPECT_EQ(hand.session.document().state()->pattern.facets.size(), 2u);
  EXPECT_TRUE(isFlat(*hand.session.document().state()));
}

TEST(Session, EscapeDropsWhatIsDrawnAndLeavesNothing) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  const std::string before = writeKiri(hand.session.document().model());
  hand.drag({100, 100}, {20, 30});
  EXPECT_TRUE(hand.key(Key::Escape));
  EXPECT_FALSE(hand.session.shown().isPreview);
  EXPECT_FALSE(hand.session.canCommit());
  EXPECT_TRUE(hand.session.fields().empty());
  EXPECT_EQ(writeKiri(hand.session.document().model()), before);
}

TEST(Session, UndoAndRedoWalkBothWays) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  hand.drag({100, 100}, {0, 0});
  hand.session.commit();
  hand.session.undo();
  EXPECT_EQ(hand.stepCount(), 0u);
  EXPECT_EQ(hand.session.document().state()->pattern.facets.size(), 1u);
  EXPECT_FALSE(hand.session.document().isModified());
  hand.session.redo();
  EXPECT_EQ(hand.stepCount(), 1u);
  EXPECT_TRUE(hand.session.document().isModified());
}

TEST(Session, UndoFirstDropsWhatIsHalfDrawn) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold a valley 50,0 50,100 left");
  hand.drag({90, 90}, {70, 70});
  hand.session.undo();
  EXPECT_EQ(hand.stepCount(), 1u);
  EXPECT_FALSE(hand.session.canCommit());
  hand.session.undo();
  EXPECT_EQ(hand.stepCount(), 0u);
}

TEST(Session, EnterMayBeFasterThanThePreview) {
  HandRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  hand.drag({100, 100}, {0, 0});
  EXPECT_TRUE(hand.key(Key::Enter));
  EXPECT_EQ(hand.stepCount(), 0u);
  runner.runAll();
  EXPECT_EQ(hand.stepCount(), 1u);
}

TEST(Session, AQuickHandIsServedInOrder) {
  HandRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  hand.session.change(addStep(test::stepOf("fold a valley 50,0 50,100 left")), {});
  hand.session.change(addStep(test::stepOf("fold b valley 0,50 100,50 right")), {});
  hand.session.undo();
  hand.session.change(addStep(test::stepOf("turn")), {});
  EXPECT_TRUE(hand.session.isBusy());
  runner.runAll();
  EXPECT_FALSE(hand.session.isBusy());
  const Model saved = hand.session.document().modelToSave();
  ASSERT_EQ(saved.steps.size(), 2u);
  EXPECT_EQ(std::get<FoldStep>(saved.steps[0].action).name, "a");
  EXPECT_TRUE(std::holds_alternative<TurnOverStep>(saved.steps[1].action));
}

TEST(Session, CancelledWorkChangesNothing) {
  HandRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  hand.session.change(addStep(test::stepOf("turn")), {});
  hand.session.change(addStep(test::stepOf("turn")), {});
  hand.session.cancelWork();
  runner.runAll();
  EXPECT_EQ(hand.stepCount(), 0u);
  EXPECT_FALSE(hand.session.isBusy());
  EXPECT_NE(hand.session.notice().kind, Notice::Kind::Refused) << "nobody complains of an order";
}

TEST(Session, ARefusedChangeSaysWhyAndWhere) {
  DirectRunner runner;
  Hand hand(runner);
  // Folded into quarters, a line through one layer alone would stretch the paper.
  hand.open("square 100; fold a valley 50,0 50,100 left; fold b valley @model 50,50 100,50 left");
  const std::string before = writeKiri(hand.session.document().model());
  hand.session.change(addStep(test::stepOf("fold c valley @model 75,0 75,50 left top 1")), {});
  EXPECT_EQ(hand.session.notice().kind, Notice::Kind::Refused);
  EXPECT_NE(hand.session.notice().why.find("stretch"), std::string::npos)
      << hand.session.notice().why;
  const Marks marks = hand.session.marks();
  EXPECT_TRUE(std::any_of(marks.begin(), marks.end(), [](const Mark& mark) {
    const auto* path = std::get_if<PathMark>(&mark);
    return path && path->role == MarkRole::Fault;
  }));
  EXPECT_EQ(writeKiri(hand.session.document().model()), before);
}

TEST(Session, ASliderShowsTheWayAndMakesAStepWhenItIsLetGo) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold a valley 50,0 50,100 left");
  const FoldLineId line = hand.session.sliders().front().line;
  hand.session.beginSlide(line);
  hand.session.slide(90);
  ASSERT_TRUE(hand.session.slideShow());
  EXPECT_NEAR(hand.session.slideShow()->amount, 90, 1e-9);
  EXPECT_FALSE(isFlat(*hand.session.shown().state));
  EXPECT_EQ(hand.stepCount(), 1u);
  hand.session.endSlide(true);
  ASSERT_EQ(hand.stepCount(), 2u);
  const auto step = std::get<AngleStep>(hand.session.document().model().steps.back().action);
  EXPECT_NEAR(step.angle, 90, 1e-9);
}

TEST(Session, ASliderThatIsGivenUpSpringsBack) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold a valley 50,0 50,100 left");
  hand.session.beginSlide(hand.session.sliders().front().line);
  hand.session.slide(20);
  EXPECT_TRUE(hand.key(Key::Escape));
  EXPECT_EQ(hand.stepCount(), 1u);
  EXPECT_EQ(hand.session.shown().state, hand.session.document().state());
}

TEST(Session, AllFoldLinesOpenWithOneSlider) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold a valley 20,0 20,100 left; fold b valley 80,0 80,100 right");
  hand.session.setLeaf(true);
  EXPECT_TRUE(hand.session.isLeaf());
  EXPECT_NEAR(hand.session.openness(), 0, 1e-9);
  hand.session.beginSlideAll();
  hand.session.slideAll(0.5);
  ASSERT_FALSE(hand.session.slideProblem()) << hand.session.slideProblem()->message;
  EXPECT_FALSE(isFlat(*hand.session.shown().state)) << hand.session.openness();
  EXPECT_NEAR(hand.session.openness(), 0.5, 1e-9);
  hand.session.slideAll(1);
  hand.session.endSlideAll(true);
  ASSERT_EQ(hand.stepCount(), 3u);
  const auto step = std::get<UnfoldStep>(hand.session.document().model().steps.back().action);
  EXPECT_EQ(step.sequence, Sequence::Together);
  for (const FoldSlider& slider : hand.session.sliders()) EXPECT_NEAR(*slider.amount, 0, 1e-9);
  EXPECT_NEAR(hand.session.openness(), 1, 1e-9);
}

TEST(Session, TheFilmPlaysAndLeavesTheModelAlone) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold a valley 50,0 50,100 left");
  const std::string before = writeKiri(hand.session.document().model());
  hand.session.openPlayer();
  ASSERT_TRUE(hand.session.isPlayerOpen());
  EXPECT_EQ(hand.session.shown().state->pattern.facets.size(), 1u) << "from the start";
  hand.session.advance(1.2);
  const Shown middle = hand.session.shown();
  EXPECT_FALSE(isFlat(*middle.state));
  hand.session.advance(0.1);
  EXPECT_GT(hand.session.shown().revision, middle.revision);
  hand.session.pointer(
      {PointerAction::Move, Pane::Model, {10, 10}, PointerButton::None, {}, false});
  hand.session.closePlayer();
  EXPECT_EQ(hand.session.shown().state, hand.session.document().state());
  EXPECT_EQ(writeKiri(hand.session.document().model()), before);
}

TEST(Session, SpaceTappedPlaysAndHeldShifts) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold a valley 50,0 50,100 left");
  hand.key(Key::Space);
  hand.session.key({Key::Space, 0, {}, false});
  EXPECT_TRUE(hand.session.isPlayerOpen());
  hand.session.closePlayer();

  const Vec2 before = hand.pixels({50, 50});
  hand.key(Key::Space);
  hand.send(PointerAction::Press, {400, 300}, PointerButton::Left);
  hand.send(PointerAction::Move, {430, 280}, PointerButton::Left);
  hand.send(PointerAction::Release, {430, 280}, PointerButton::Left);
  hand.session.key({Key::Space, 0, {}, false});
  EXPECT_FALSE(hand.session.isPlayerOpen()) << "that was no tap";
  EXPECT_NEAR(distance(hand.pixels({50, 50}), before + Vec2{30, -20}), 0, 1e-6);
}

TEST(Session, TheRightButtonTurnsTheModelAndNoTool) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  const Vec3 before = hand.map().frame.toEye;
  hand.drag({50, 50}, {80, 60}, false, PointerButton::Right);
  EXPECT_GT(distance(hand.map().frame.toEye, before), 0.1);
  EXPECT_FALSE(hand.session.canCommit());
}

TEST(Session, TheWheelKeepsThePlaceUnderThePointer) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  for (const Pane pane : {Pane::Model, Pane::Sheet}) {
    hand.pane = pane;
    const Vec2 at = hand.pixels({20, 30});
    const double scale = hand.map().pixelsPerMm;
    hand.session.wheel({pane, at, 3, {}});
    EXPECT_GT(hand.map().pixelsPerMm, scale * 1.5);
    EXPECT_NEAR(distance(hand.pixels({20, 30}), at), 0, 1e-6);
  }
}

TEST(Session, PaperThatGrowsOutOfThePaneIsShownWhole) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; cut -5,45 45,-5 keep 5,5");
  for (const Pane pane : {Pane::Model, Pane::Sheet}) {
    hand.pane = pane;
    EXPECT_LT(hand.pixels({100, 100}).y, 0) << "only the corner is there, and large";
  }
  hand.session.jumpTo(0);
  for (const Pane pane : {Pane::Model, Pane::Sheet}) {
    hand.pane = pane;
    const Vec2 corner = hand.pixels({100, 100});
    EXPECT_GT(corner.y, 0);
    EXPECT_LT(corner.x, hand.map().size.x);
  }
}

TEST(Session, WhoHasComeNearStaysNear) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold a valley 50,0 50,100 left");
  hand.session.wheel({Pane::Model, {400, 300}, 12, {}});
  const double scale = hand.map().pixelsPerMm;
  hand.session.jumpTo(0);
  EXPECT_NEAR(hand.map().pixelsPerMm, scale, 1e-9);
}

TEST(Session, WhatIsSelectedSaysTheLayersOfOneFold) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100; fold A valley 50,0 50,100 left");
  hand.session.setTool(ToolId::Select);
  hand.click({75, 30});
  ASSERT_FALSE(hand.session.selection().isEmpty());
  hand.session.setTool(ToolId::Fold);
  hand.drag({99.5, 99.5}, {75, 75});
  EXPECT_FALSE(hand.session.selection().isEmpty()) << "it counts as long as the fold is drawn";
  hand.key(Key::Enter);
  ASSERT_EQ(hand.stepCount(), 2U) << hand.session.notice().why;
  EXPECT_TRUE(hand.session.selection().isEmpty()) << "the next fold may be elsewhere";
}

TEST(Session, AnotherModelLeavesNothingOfTheFirst) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open("square 100");
  hand.drag({100, 100}, {20, 30});
  hand.open("disc 80");
  EXPECT_FALSE(hand.session.canCommit());
  EXPECT_FALSE(hand.session.shown().isPreview);
  EXPECT_TRUE(hand.session.selection().isEmpty());
  EXPECT_EQ(hand.session.facts().facets, 1u);
}

TEST(MovedFacets, AreThoseThatLieElsewhere) {
  const FoldedState before = test::run("square 100");
  const FoldedState after = test::run("square 100; fold a valley 30,0 30,100 left");
  const std::vector<bool> moved = movedFacets(before, after);
  ASSERT_EQ(moved.size(), 2u);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    EXPECT_EQ(moved[i], interiorPointOf(after.pattern, FacetId(i)).x < 30);
  }
  const std::vector<bool> same = movedFacets(after, after);
  EXPECT_EQ(std::count(same.begin(), same.end(), true), 0);
}

}  // namespace
}  // namespace kiri
