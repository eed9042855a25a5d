// Patterns in a session: opened, looked at, walked state by state, picked, folded on, undone.
// SPDX-License-Identifier: MIT
#include "editor/session/pattern_desk.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "editor/document/journal.h"
#include "io/kiri_writer.h"
#include "tests/editor/base/hand_runner.h"
#include "tests/editor/session/hand.h"
#include "tests/editor/session/pattern_texts.h"

namespace kiri {
namespace {

using test::Hand;

void openPattern(Hand& hand, const std::string& text) {
  Result<PatternImport> made = importPattern(text, "test.fold");
  ASSERT_TRUE(made.isOk()) << made.error().message;
  Result<Document> document = Document::create(std::move(made->model));
  ASSERT_TRUE(document.isOk());
  hand.session.open(std::move(*document), std::move(made->report));
}

const PatternView& viewOf(Hand& hand) { return hand.session.pattern().view(); }

/// The facets from the bottom to the top, as one number.
std::string orderOf(Hand& hand) {
  std::string order;
  const LayerOrder& layers = hand.session.document().state()->layers;
  for (const LayerSet& set : layers.sets()) {
    for (const FacetId facet : set.upward) order += std::to_string(facet.index) + " ";
  }
  return order;
}

/// The facet that a person in front of the model sees at a place of it.
FacetId seenAt(Hand& hand, Vec2 place) {
  const auto spot = locatePlace(*hand.session.document().state(), {Frame::Model, place});
  EXPECT_TRUE(spot.isOk());
  return spot->facet;
}

TEST(PatternDesk, AMapHasEightStatesAndWalkingThemComesBack) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  ASSERT_EQ(viewOf(hand).verdict, PatternVerdict::FoldsFlat) << viewOf(hand).why;
  EXPECT_EQ(viewOf(hand).total, "8");
  ASSERT_EQ(viewOf(hand).components.size(), 1u);
  EXPECT_EQ(viewOf(hand).components.front().count, "8");
  const std::string before = writeKiri(hand.session.document().model());
  std::set<std::string> orders{orderOf(hand)};
  std::set<std::string> numbers{viewOf(hand).components.front().number};
  for (int i = 1; i < 8; ++i) {
    hand.session.pattern().walk(0, 1);
    EXPECT_EQ(hand.session.notice().kind, Notice::Kind::Done) << hand.session.notice().why;
    orders.insert(orderOf(hand));
    numbers.insert(viewOf(hand).components.front().number);
  }
  EXPECT_EQ(orders.size(), 8u);
  EXPECT_EQ(numbers.size(), 8u);
  EXPECT_EQ(hand.stepCount(), 1u) << "the pattern's own step is changed, none is added";
  hand.session.pattern().walk(0, 1);
  EXPECT_EQ(writeKiri(hand.session.document().model()), before) << "after the last comes the first";
  hand.session.pattern().walk(0, -1);
  EXPECT_EQ(orders.count(orderOf(hand)), 1u);
}

TEST(PatternDesk, EveryChoiceIsUndoneByItself) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  const std::string first = orderOf(hand);
  const std::string number = viewOf(hand).components.front().number;
  hand.session.pattern().walk(0, 1);
  const std::string second = orderOf(hand);
  hand.session.pattern().walk(0, 1);
  EXPECT_NE(first, second);
  hand.session.undo();
  EXPECT_EQ(orderOf(hand), second);
  hand.session.undo();
  EXPECT_EQ(orderOf(hand), first);
  EXPECT_EQ(viewOf(hand).components.front().number, number) << "known again";
  hand.session.redo();
  EXPECT_EQ(orderOf(hand), second);
}

TEST(PatternDesk, AStateIsShownByItsNumber) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  std::set<std::string> orders;
  for (const char* number : {"1", "2", "3", "4", "5", "6", "7", "8"}) {
    hand.session.pattern().choose(0, number);
    EXPECT_EQ(viewOf(hand).components.front().number, number);
    orders.insert(orderOf(hand));
  }
  EXPECT_EQ(orders.size(), 8u);
  hand.session.pattern().choose(0, "9");
  EXPECT_EQ(hand.session.notice().kind, Notice::Kind::Refused);
  hand.session.pattern().choose(0, "nonsense");
  EXPECT_EQ(viewOf(hand).components.front().number, "8");
}

TEST(PatternDesk, AQuickHandIsNotLost) {
  HandRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  runner.runAll();
  ASSERT_EQ(viewOf(hand).total, "8");
  hand.session.pattern().choose(0, "1");
  runner.runAll();
  for (int i = 0; i < 3; ++i) {
    hand.session.pattern().walk(0, 1);
    runner.runOne();  // found, but not yet in the document
  }
  runner.runAll();
  EXPECT_EQ(viewOf(hand).components.front().number, "4");
  Hand other(runner);
  openPattern(other, writeKiri(hand.session.document().model()).empty() ? "" : test::kMap);
  runner.runAll();
  other.session.pattern().choose(0, "4");
  runner.runAll();
  EXPECT_EQ(orderOf(hand), orderOf(other)) << "the document has what the number says";
}

TEST(PatternDesk, EveryLayerOfAMapCanBeBroughtOnTop) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  hand.session.setTool(ToolId::TopLayer);
  const FoldedState& flat = *hand.session.document().state();
  const Vec3 middle = flat.poseOf(FacetId(0)).apply(interiorPointOf(flat.pattern, FacetId(0)));
  const Vec2 place{middle.x, middle.y};
  for (int layer = 2; layer <= 4; ++layer) {
    hand.click(place);
    hand.set("layer", layer);
    const FacetId before = seenAt(hand, place);
    hand.key(Key::Enter);
    ASSERT_NE(hand.session.notice().kind, Notice::Kind::Refused) << hand.session.notice().why;
    EXPECT_NE(seenAt(hand, place), before);
  }
  EXPECT_EQ(hand.stepCount(), 1u);
}

TEST(PatternDesk, WhatCannotLieOnTopIsRefusedWithAReason) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kAccordion);
  ASSERT_EQ(viewOf(hand).total, "1");
  const std::string before = orderOf(hand);
  hand.session.setTool(ToolId::TopLayer);
  const FoldedState& flat = *hand.session.document().state();
  const Vec3 middle = flat.poseOf(FacetId(0)).apply(interiorPointOf(flat.pattern, FacetId(0)));
  hand.click({middle.x, middle.y});
  EXPECT_FALSE(hand.session.fields().empty());
  hand.key(Key::Enter);
  EXPECT_EQ(hand.session.notice().kind, Notice::Kind::Refused);
  EXPECT_FALSE(hand.session.notice().why.empty());
  EXPECT_EQ(orderOf(hand), before);
}

TEST(PatternDesk, LaterStepsFollowTheChosenState) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  hand.session.change(addStep(test::stepOf("fold on valley @model 25,0 25,100 left")), {});
  ASSERT_EQ(hand.stepCount(), 2u) << hand.session.notice().why;
  const std::size_t facets = hand.session.document().state()->pattern.facets.size();
  hand.session.pattern().walk(0, 1);
  EXPECT_EQ(hand.stepCount(), 2u);
  EXPECT_FALSE(hand.session.document().problemOf(0));
  EXPECT_EQ(hand.session.document().state()->pattern.facets.size(), facets);
  for (int i = 0; i < 3; ++i) hand.session.undo();
  EXPECT_EQ(hand.stepCount(), 0u) << "all is undone";
  EXPECT_FALSE(viewOf(hand).step) << "the sheet has no pattern any more";
}

TEST(PatternDesk, ABrokenPatternShowsItsFaultsInTheSheet) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kBroken);
  EXPECT_EQ(viewOf(hand).verdict, PatternVerdict::FoldsNot);
  EXPECT_FALSE(viewOf(hand).why.empty());
  ASSERT_FALSE(viewOf(hand).faults.empty());
  EXPECT_NEAR(distance(viewOf(hand).faultPlaces.front(), Vec2{50, 50}), 0, 1e-9);
  const auto faults = [&] {
    int points = 0;
    for (const Mark& mark : hand.session.marks()) {
      const auto* point = std::get_if<PointMark>(&mark);
      points += point && point->role == MarkRole::Fault ? 1 : 0;
    }
    return points;
  };
  EXPECT_GE(faults(), 1);
  hand.session.lookAt({PatternEntry::Kind::Fault, 0});
  hand.pane = Pane::Sheet;
  EXPECT_NEAR(distance(hand.pixels({50, 50}), Vec2{200, 300}), 0, 1e-6) << "in the middle";
  hand.session.pattern().showFaults(false);
  EXPECT_EQ(faults(), 0);
}

TEST(PatternDesk, RepairsAreToldAndPointedAt) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kCrossing);
  ASSERT_FALSE(viewOf(hand).report.repairs.empty());
  const Repair& repair = viewOf(hand).report.repairs.front();
  EXPECT_GE(repair.count, 1u);
  ASSERT_FALSE(repair.places.empty());
  EXPECT_NEAR(distance(repair.places.front(), Vec2{50, 50}), 0, 1e-9);
  hand.session.lookAt({PatternEntry::Kind::Repair, 0});
  EXPECT_EQ(hand.session.pattern().pointed().kind, PatternEntry::Kind::Repair);
}

TEST(PatternDesk, TheChosenStateIsInTheJournalAndOpensWithoutASearch) {
  DirectRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  hand.session.pattern().choose(0, "5");
  const Document& document = hand.session.document();
  const auto read = readJournal(writeJournal({document.model(), document.count(), ""}), "journal");
  ASSERT_TRUE(read.isOk()) << read.error().message;
  EXPECT_TRUE(read->model == document.model());
  Hand other(runner);
  other.open(read->model);
  EXPECT_EQ(orderOf(other), orderOf(hand));
  EXPECT_EQ(viewOf(other).components.front().number, "5") << "found among the first";
}

TEST(PatternDesk, TheNewestModelIsTheOneThatIsSearched) {
  HandRunner runner;
  Hand hand(runner);
  openPattern(hand, test::kMap);
  openPattern(hand, test::kAccordion);
  runner.runAll();
  EXPECT_EQ(viewOf(hand).total, "1");
  hand.open("square 100");
  runner.runAll();
  EXPECT_FALSE(viewOf(hand).step);
}

}  // namespace
}  // namespace kiri
