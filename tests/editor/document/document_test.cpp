// The open document: every change can be undone, what is saved is what counts.
// SPDX-License-Identifier: MIT
#include "editor/document/document.h"

#include <gtest/gtest.h>

#include "editor/document/step_fields.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

const char* const kThree =
    "square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left; angle B "
    "90";

Document opened(const char* text) { return Document::create(modelOf(text)).value(); }

/// Makes a change that must succeed.
void make(Document& document, const Change& change, const char* what = "change") {
  Result<History> next = change(document.history(), {});
  ASSERT_TRUE(next.isOk()) << next.error().message;
  document.become(std::move(*next), {what, {}});
}

TEST(Document, OpensUnmodifiedAtItsLastStep) {
  const Document document = opened(kThree);
  EXPECT_EQ(document.cursor(), 3u);
  EXPECT_EQ(document.count(), 3u);
  EXPECT_FALSE(document.isModified());
  EXPECT_FALSE(document.canRedo());
  EXPECT_DOUBLE_EQ(amountOf(*document.state(), "B"), 90);
}

TEST(Document, StepsOfAnOpenedFileAreUndoneToTheStart) {
  Document document = opened(kThree);
  for (std::size_t i = 3; i > 0; --i) {
    EXPECT_EQ(document.undoPhrase(), summaryOf(document.model().steps[i - 1], i));
    EXPECT_TRUE(document.undo());
  }
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.undo());
  EXPECT_TRUE(document.undoPhrase().isEmpty());
  EXPECT_EQ(facetCount(*document.state()), 1u);
  EXPECT_EQ(document.model().steps.size(), 3u) << "what was undone can still be seen";
  EXPECT_TRUE(document.modelToSave().steps.empty()) << "but it is not saved";
}

TEST(Document, IsModifiedExactlyWhenAFileOfItWouldBeAnother) {
  Document document = opened(kThree);
  document.undo();
  EXPECT_TRUE(document.isModified());
  document.redo();
  EXPECT_FALSE(document.isModified());
  make(document, addStep(stepOf("turn")));
  EXPECT_TRUE(document.isModified());
  document.noteSaved();
  EXPECT_FALSE(document.isModified());
  document.undo();
  EXPECT_TRUE(document.isModified());
  make(document, addStep(stepOf("turn")));
  EXPECT_FALSE(document.isModified()) << "the same step again makes the same file";
}

TEST(Document, ChangesMadeWhileAFileIsWrittenAreUnsaved) {
  Document document = opened("square 100");
  make(document, addStep(stepOf("fold A valley 50,0 50,100 left")));
  const Model written = document.modelToSave();
  make(document, addStep(stepOf("turn")));
  document.noteSaved(written);
  EXPECT_TRUE(document.isModified());
  document.undo();
  EXPECT_FALSE(document.isModified());
}

TEST(Document, LookingAtAnEarlierStepChangesNothing) {
  Document document = opened(kThree);
  EXPECT_TRUE(document.jumpTo(1));
  EXPECT_EQ(facetCount(*document.state()), 2u);
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.modelToSave().steps.size(), 3u);
  EXPECT_FALSE(document.jumpTo(1));
  EXPECT_FALSE(document.jumpTo(4));
  EXPECT_TRUE(document.undo()) << "comes back";
  EXPECT_EQ(document.cursor(), 3u);
  EXPECT_FALSE(document.isModified());
}

TEST(Document, JumpingForwardRedoes) {
  Document document = opened(kThree);
  for (int i = 0; i < 3; ++i) document.undo();
  EXPECT_TRUE(document.jumpTo(2));
  EXPECT_EQ(document.count(), 2u);
  EXPECT_TRUE(document.isModified());
  EXPECT_TRUE(document.jumpTo(3));
  EXPECT_FALSE(document.isModified());
  EXPECT_FALSE(document.canRedo());
}

TEST(Document, AStepMadeAtAnEarlierPlaceCanBeUndoneToWhatWasThere) {
  Document document = opened(kThree);
  document.jumpTo(1);
  make(document, addStep(stepOf("turn")));
  EXPECT_EQ(document.model().steps.size(), 2u);
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.model().steps.size(), 3u);
  EXPECT_EQ(document.cursor(), 1u) << "as it was looked at then";
  EXPECT_FALSE(document.isModified());
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(document.model().steps.size(), 2u);
}

TEST(Document, UndoneStepsAreSeenAgainWhenAnEditIsRedone) {
  Document document = opened(kThree);
  make(document, editStep(0, stepOf("fold A valley 30,0 30,100 left")), "edit");
  make(document, addStep(stepOf("turn")));
  document.undo();
  EXPECT_EQ(document.model().steps.size(), 4u);
  document.undo();
  EXPECT_EQ(document.model().steps.size(), 3u);
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.redoPhrase().text, "edit");
  document.redo();
  EXPECT_EQ(document.model().steps.size(), 4u);
  EXPECT_EQ(document.count(), 3u);
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(document.count(), 4u);
  EXPECT_FALSE(document.redo());
}

TEST(Document, ANewChangeDropsWhatWasUndone) {
  Document document = opened(kThree);
  document.undo();
  make(document, setTitle("a boat", ""));
  EXPECT_EQ(document.model().steps.size(), 2u);
  EXPECT_FALSE(document.canRedo());
  document.undo();
  EXPECT_EQ(document.model().title, "");
  EXPECT_EQ(document.model().steps.size(), 2u);
}

TEST(Document, AChangeThatChangesNothingIsNoVersion) {
  Document document = opened("square 100");
  make(document, setSides(document.model().front, document.model().back));
  make(document, setSheet(document.model().sheet));
  EXPECT_FALSE(document.canUndo());
  make(document, setSides({{1, 2, 3}, ""}, document.model().back));
  EXPECT_TRUE(document.canUndo());
  EXPECT_TRUE(document.isModified());
}

TEST(Document, AnotherSheetIsUndone) {
  Document document = opened("square 100; fold A valley 50,0 50,100 left");
  SheetSpec sheet = document.model().sheet;
  sheet.width = 80;
  make(document, setSheet(sheet));
  EXPECT_DOUBLE_EQ(areaOf(*document.state()), 6400);
  document.undo();
  EXPECT_DOUBLE_EQ(areaOf(*document.state()), 10000);
  EXPECT_FALSE(document.isModified());
  sheet.width = -1;
  const Result<History> refused = setSheet(sheet)(document.history(), {});
  ASSERT_FALSE(refused.isOk());
  EXPECT_EQ(refused.error().code, ErrorCode::BadValue);
}

TEST(Document, AddedStepsMeanTheSameWhateverTheViewAndTheNumber) {
  Document document = opened("square 100");
  make(document, addStep(stepOf("fold valley @model 50,0 50,100 left top 1")));
  const auto& fold = std::get<FoldStep>(document.model().steps[0].action);
  EXPECT_EQ(fold.line.frame, Frame::Paper);
  EXPECT_EQ(fold.name, "fold 1");
  EXPECT_TRUE(std::holds_alternative<ChosenLayers>(fold.layers));
}

TEST(Document, AFoldWithoutANameGetsOneThatIsFree) {
  Model model =
      modelOf("square 100; turn; fold valley 50,0 50,100 left; fold X mountain 75,0 75,100 left");
  std::get<FoldStep>(model.steps[2].action).name = "fold 4";
  Document document = Document::create(model).value();
  make(document, removeStep(0));
  EXPECT_EQ(std::get<FoldStep>(document.model().steps[0].action).name, "fold 2")
      << "it keeps the name that came from its number";
  make(document, addStep(stepOf("turn")));
  make(document, addStep(stepOf("fold valley @model 50,20 110,20 left")));
  EXPECT_EQ(std::get<FoldStep>(document.model().steps[3].action).name, "fold 5");
}

TEST(Document, AnEditThatTakesLongCanBeStopped) {
  const Document document = opened(kThree);
  const Result<History> stopped = editStep(0, stepOf("fold A valley 30,0 30,100 left"))(
      document.history(), [](double) { return false; });
  ASSERT_FALSE(stopped.isOk());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(std::get<FoldStep>(document.model().steps[0].action).line.from.x, 50);
}

TEST(Document, WhatAJournalKeptIsUnsavedAndKeepsUndoneSteps) {
  Document document = Document::recovered(modelOf(kThree), 2).value();
  EXPECT_EQ(document.count(), 2u);
  EXPECT_TRUE(document.isModified());
  EXPECT_TRUE(document.redo());
  EXPECT_TRUE(document.isModified());
  document.noteSaved();
  EXPECT_FALSE(document.isModified());
}

TEST(Document, AnAddedStepSaysItselfWhatUndoTakesBack) {
  Document document = opened("square 100");
  make(document, addStep(stepOf("fold A valley 50,0 50,100 left")), "");
  EXPECT_EQ(inEnglish(document.undoPhrase()), "A: valley, 180°");
  document.undo();
  EXPECT_EQ(inEnglish(document.redoPhrase()), "A: valley, 180°");
  document.redo();
  document.jumpTo(0);
  make(document, addStep(stepOf("rotate 30")), "");
  EXPECT_EQ(inEnglish(document.undoPhrase()), "rotate by 30°");
}

TEST(Document, EveryChangeOfWhatIsSeenCountsTheRevisionUp) {
  Document document = opened(kThree);
  std::uint64_t last = document.revision();
  const auto grows = [&] {
    const bool doesGrow = document.revision() > last;
    last = document.revision();
    return doesGrow;
  };
  document.undo();
  EXPECT_TRUE(grows());
  document.redo();
  EXPECT_TRUE(grows());
  document.jumpTo(1);
  EXPECT_TRUE(grows());
  make(document, addStep(stepOf("turn")));
  EXPECT_TRUE(grows());
  document.redo();
  EXPECT_FALSE(grows()) << "there was nothing to redo";
}

TEST(Document, RenamingAFoldKeepsTheStepsThatNameIt) {
  Document document = opened(kThree);
  Step renamed = document.model().steps[1];
  std::get<FoldStep>(renamed.action).name = "roof";
  make(document, editStep(1, renamed));
  EXPECT_FALSE(document.problemOf(2).has_value());
  EXPECT_DOUBLE_EQ(amountOf(*document.state(), "roof"), 90);
  std::get<FoldStep>(renamed.action).name = "A";
  const Result<History> refused = editStep(1, renamed)(document.history(), {});
  ASSERT_FALSE(refused.isOk()) << "the name of another fold";
  EXPECT_EQ(refused.error().code, ErrorCode::BadValue);
}

}  // namespace
}  // namespace kiri::test
