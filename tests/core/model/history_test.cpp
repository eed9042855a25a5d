// Replaying, undoing and editing: steps that no longer apply are kept and marked.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/model/history.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

const char* const kThree =
    "square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left; angle B "
    "90";

History opened(const char* text) { return History::open(modelOf(text)).value(); }

TEST(Replay, GivesTheStateAfterEveryStep) {
  const Replay replayed = replay(modelOf(kThree)).value();
  ASSERT_EQ(replayed.outcomes.size(), 3u);
  EXPECT_EQ(facetCount(**replayed.after(0)), 1u);
  EXPECT_EQ(facetCount(**replayed.after(1)), 2u);
  EXPECT_EQ(facetCount(**replayed.after(2)), 4u);
  EXPECT_DOUBLE_EQ(amountOf(**replayed.after(3), "B"), 90);
}

TEST(Replay, MarksAStepThatDoesNotApplyAndThoseThatWaitForIt) {
  const Replay replayed =
      replay(modelOf("square 100; angle A 90; fold A valley 50,0 50,100 left")).value();
  ASSERT_EQ(replayed.outcomes.size(), 2u);
  EXPECT_FALSE(replayed.outcomes[0].state);
  ASSERT_TRUE(replayed.outcomes[0].error.has_value());
  EXPECT_EQ(replayed.outcomes[0].error->code, ErrorCode::NotFound);
  EXPECT_FALSE(replayed.outcomes[1].state);
  EXPECT_TRUE(replayed.outcomes[1].error.has_value());
  const auto last = replayed.after(2);
  ASSERT_FALSE(last.isOk());
  EXPECT_NE(last.error().message.find("step 1"), std::string::npos) << last.error().message;
}

TEST(Replay, StopsWhenProgressSaysSo) {
  int calls = 0;
  const Result<Replay> stopped = replay(modelOf(kThree), [&calls](double) { return ++calls < 2; });
  ASSERT_FALSE(stopped.isOk());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

TEST(Replay, TellsProgressThatGrows) {
  double last = -1;
  const Result<Replay> done = replay(modelOf(kThree), [&last](double part) {
    EXPECT_GE(part, last);
    EXPECT_LE(part, 1);
    last = part;
    return true;
  });
  EXPECT_TRUE(done.isOk());
}

TEST(Replay, RefusesASheetThatIsNone) {
  Model model;
  model.sheet.width = -5;
  const Result<Replay> result = replay(model);
  ASSERT_FALSE(result.isOk());
  EXPECT_EQ(result.error().code, ErrorCode::BadValue);
}

TEST(History, UndoThenRedoIsTheSameState) {
  History history = opened(kThree);
  EXPECT_EQ(history.cursor(), 3u);
  const FoldedState last = history.state();
  EXPECT_TRUE(history.undo());
  EXPECT_DOUBLE_EQ(amountOf(history.state(), "B"), 180);
  EXPECT_TRUE(history.redo());
  EXPECT_TRUE(isSameState(history.state(), last));
  EXPECT_FALSE(history.redo());
}

TEST(History, UndoneToTheSheetHasNothingToUndo) {
  History history = opened(kThree);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(history.undo());
  EXPECT_FALSE(history.undo());
  EXPECT_EQ(facetCount(history.state()), 1u);
}

TEST(History, ANewStepDropsWhatWasUndone) {
  History history = opened(kThree);
  history.undo();
  history.undo();
  EXPECT_TRUE(history.add(stepOf("turn")).isOk());
  EXPECT_EQ(history.model().steps.size(), 2u);
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(facetCount(history.state()), 2u);
}

TEST(History, AStepThatDoesNotApplyIsNotAdded) {
  History history = opened(kThree);
  const FoldedState before = history.state();
  const Status added = history.add(stepOf("angle nobody 90"));
  ASSERT_FALSE(added.isOk());
  EXPECT_EQ(added.error().code, ErrorCode::NotFound);
  EXPECT_EQ(history.model().steps.size(), 3u);
  EXPECT_TRUE(isSameState(history.state(), before));
}

TEST(History, AFailedStepKeepsWhatWasUndone) {
  History history = opened(kThree);
  history.undo();
  EXPECT_FALSE(history.add(stepOf("angle nobody 90")).isOk());
  EXPECT_TRUE(history.redo());
}

TEST(History, EditingAnEarlierStepReplaysTheLaterOnes) {
  History history = opened(kThree);
  EXPECT_TRUE(history.edit(0, stepOf("fold A valley 30,0 30,100 left")).isOk());
  EXPECT_FALSE(history.problemOf(1).has_value());
  EXPECT_TRUE(liesAt(history.state(), {0, 25}, {60, 25, 0}));
  EXPECT_DOUBLE_EQ(amountOf(history.state(), "B"), 90);
}

TEST(History, AStepThatNoLongerAppliesIsKeptAndMarked) {
  History history = opened(kThree);
  EXPECT_TRUE(history.edit(1, stepOf("turn")).isOk());
  EXPECT_EQ(history.model().steps.size(), 3u);
  EXPECT_FALSE(history.problemOf(1).has_value());
  ASSERT_TRUE(history.problemOf(2).has_value());
  EXPECT_EQ(history.problemOf(2)->code, ErrorCode::NotFound);
  EXPECT_EQ(facetCount(history.state()), 2u) << "the last state that there is";
  // Putting the fold back heals the step that was kept.
  EXPECT_TRUE(history.edit(1, stepOf("fold B valley @model 40,50 110,50 left")).isOk());
  EXPECT_FALSE(history.problemOf(2).has_value());
  EXPECT_DOUBLE_EQ(amountOf(history.state(), "B"), 90);
}

TEST(History, RemovingAStepReplaysTheRest) {
  History history = opened(kThree);
  EXPECT_TRUE(history.remove(0).isOk());
  EXPECT_EQ(history.model().steps.size(), 2u);
  EXPECT_EQ(history.cursor(), 2u);
  EXPECT_FALSE(history.problemOf(1).has_value());
  EXPECT_EQ(facetCount(history.state()), 2u);
}

TEST(History, EditingBeyondTheEndIsAnError) {
  History history = opened(kThree);
  EXPECT_FALSE(history.edit(3, stepOf("turn")).isOk());
  EXPECT_FALSE(history.remove(7).isOk());
}

TEST(History, LookingAtAnEarlierStepTakesNoneOutOfForce) {
  History history = opened(kThree);
  EXPECT_TRUE(history.moveTo(1));
  EXPECT_EQ(history.cursor(), 1u);
  EXPECT_EQ(history.count(), 3u);
  EXPECT_EQ(facetCount(history.state()), 2u);
  EXPECT_FALSE(history.moveTo(1));
  EXPECT_FALSE(history.moveTo(4));
  history.undo();
  EXPECT_EQ(history.cursor(), 2u);
  EXPECT_TRUE(history.moveTo(3)) << "redoes";
  EXPECT_EQ(history.count(), 3u);
}

TEST(History, AChangeDropsWhatWasUndone) {
  History history = opened(kThree);
  history.undo();
  const Status undone = history.edit(2, stepOf("turn"));
  ASSERT_FALSE(undone.isOk());
  EXPECT_NE(undone.error().message.find("redo it"), std::string::npos) << undone.error().message;
  EXPECT_TRUE(history.edit(0, stepOf("fold A valley 30,0 30,100 left")).isOk());
  EXPECT_EQ(history.model().steps.size(), 2u);
  EXPECT_FALSE(history.edit(2, stepOf("turn")).isOk()) << "there is none";
}

TEST(History, AStoppedChangeChangesNothing) {
  History history = opened(kThree);
  const auto never = [](double) { return false; };
  SheetSpec sheet;
  for (const Status& stopped : {history.edit(0, stepOf("turn"), never), history.remove(0, never),
                                history.setSheet(sheet, never)}) {
    ASSERT_FALSE(stopped.isOk());
    EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  }
  EXPECT_EQ(history.model(), modelOf(kThree));
  EXPECT_DOUBLE_EQ(amountOf(history.state(), "B"), 90);
}

TEST(History, TwoHistoriesDifferByLittleWhereTheyAreAlike) {
  const History three = opened(kThree);
  History four = three;
  ASSERT_TRUE(four.add(stepOf("turn")).isOk());
  EXPECT_TRUE(four.differenceTo(three).steps.empty());
  EXPECT_EQ(three.differenceTo(four).steps.size(), 1u);
  History edited = four;
  ASSERT_TRUE(edited.edit(2, stepOf("angle B 45")).isOk());
  EXPECT_EQ(edited.differenceTo(four).first, 2u);
  EXPECT_FALSE(edited.differenceTo(four).head.has_value());
  History titled = four;
  titled.setTitle("boat", "floats");
  const HistoryDifference difference = titled.differenceTo(four);
  EXPECT_TRUE(difference.steps.empty());
  ASSERT_TRUE(difference.head.has_value());
  EXPECT_EQ(difference.head->steps.capacity(), 0u) << "no room is kept for steps";
}

TEST(History, ExchangingADifferenceGoesThereAndBack) {
  const History one = opened(kThree);
  History other = one;
  ASSERT_TRUE(other.edit(1, stepOf("turn")).isOk());
  other.setTitle("boat", "");
  other.undo();
  for (const bool isForgotten : {false, true}) {
    History history = one;
    HistoryDifference difference = one.differenceTo(other);
    if (isForgotten) difference.outcomes.clear();
    HistoryDifference back = history.exchange(std::move(difference));
    EXPECT_EQ(history.model(), other.model());
    EXPECT_EQ(history.count(), 2u);
    EXPECT_TRUE(isSameState(history.state(), other.state()));
    history.exchange(std::move(back));
    EXPECT_EQ(history.model(), one.model());
    EXPECT_EQ(history.cursor(), 3u);
    EXPECT_TRUE(isSameState(history.state(), one.state()));
  }
}

TEST(History, RefusesTheNameOfAnotherFoldAndNumbersThatNoFileHolds) {
  History history = opened(kThree);
  const Status named = history.edit(0, stepOf("fold B valley 30,0 30,100 left"));
  ASSERT_FALSE(named.isOk());
  EXPECT_EQ(named.error().code, ErrorCode::BadValue);
  Step step = history.model().steps[2];
  std::get<AngleStep>(step.action).angle = std::nan("");
  EXPECT_EQ(history.edit(2, step).error().code, ErrorCode::BadValue);
}

TEST(History, KeepsTitlesAndUnknownFields) {
  Model model = modelOf(kThree);
  model.steps[1].title = "a title";
  model.steps[1].unknown = "{\"x\":1}";
  History history = History::open(model).value();
  history.undo();
  history.redo();
  EXPECT_TRUE(history.edit(0, stepOf("fold A valley 30,0 30,100 left")).isOk());
  EXPECT_EQ(history.model().steps[1].title, "a title");
  EXPECT_EQ(history.model().steps[1].unknown, "{\"x\":1}");
}

TEST(History, LinesOfAPatternAreCalledByItsNewName) {
  Model model = modelOf("square 100; angle crease_1 90; unfold");
  std::get<AngleStep>(model.steps[0].action).line = std::string("crease 1");
  PatternStep pattern;
  pattern.vertices = {{50, 0}, {50, 100}};
  pattern.creases = {{0, 1, Assignment::Valley, 180}};
  pattern.isFolded = true;
  Step first;
  first.action = pattern;
  model.steps.insert(model.steps.begin(), first);
  History history = History::open(model).value();
  EXPECT_FALSE(history.problemOf(1).has_value());
  std::get<PatternStep>(first.action).name = "book";
  ASSERT_TRUE(history.edit(0, first).isOk());
  EXPECT_EQ(std::get<AngleStep>(history.model().steps[1].action).line,
            FoldLineName(std::string("book 1")));
  EXPECT_FALSE(history.problemOf(1).has_value());
  // Flat, its lines are still there to be folded.
  std::get<PatternStep>(first.action).isFolded = false;
  ASSERT_TRUE(history.edit(0, first).isOk());
  EXPECT_FALSE(history.problemOf(1).has_value());
  EXPECT_TRUE(history.undo());
  EXPECT_DOUBLE_EQ(amountOf(history.state(), "book 1"), 90);
}

}  // namespace
}  // namespace kiri::test
