// The tour in a window: the card follows the session, the ghost is drawn over the model.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/tour_card.h"

#include <QSignalSpy>

#include "apps/desktop/dialogs/recovery_dialog.h"
#include "editor/document/journal.h"
#include "tests/apps/desktop/dialogs/dialog_test_kit.h"
#include "tests/support/model_text.h"

namespace kiri::desktop {
namespace {

class TourCardTest : public test::DialogTest {
 protected:
  TourCardTest() : hub_(runner_), card_(hub_, &window_) {
    window_.resize(900, 620);
    hub_.session().open(Document::create(Tour::startModel()).value());
    hub_.session().resize(Pane::Model, {900, 620});
  }
  void doStep(const char* text) {
    hub_.session().change(addStep(kiri::test::stepOf(text)), {"Fold", {}});
    ASSERT_TRUE(test::waitFor([&] { return !hub_.session().isBusy(); }));
    hub_.flush();
  }
  QString words() const {
    QString all;
    for (const QLabel* label : card_.findChildren<QLabel*>()) all += label->text() + "\n";
    return all;
  }
  bool hasGhost() {
    for (const Mark& mark : hub_.session().marks()) {
      const auto* path = std::get_if<PathMark>(&mark);
      if (path && path->role == MarkRole::Ghost) return true;
    }
    return false;
  }
  QWidget window_;
  SessionHub hub_;
  TourCard card_;
};

TEST_F(TourCardTest, FollowsTheHandStepByStepAndBack) {
  window_.show();
  EXPECT_FALSE(card_.isVisible());
  EXPECT_FALSE(hasGhost());
  card_.begin();
  test::show(window_, "tour");
  EXPECT_TRUE(card_.isVisible());
  EXPECT_TRUE(words().contains("Step 1 of 5"));
  EXPECT_EQ(hub_.session().tool(), ToolId::Fold);
  ASSERT_TRUE(test::waitFor([&] { return hasGhost(); }));

  doStep("fold valley m:0,0 m:150,150 moving m:120,20");
  EXPECT_TRUE(words().contains("Step 2 of 5"));
  doStep("turn");
  EXPECT_TRUE(words().contains("Ctrl+Z"));
  ASSERT_TRUE(test::waitFor([&] { return !hasGhost(); })) << "astray: nothing is shown";
  hub_.session().undo();
  hub_.flush();
  EXPECT_TRUE(words().contains("Step 2 of 5"));
  EXPECT_FALSE(words().contains("take it back"));
  doStep("fold valley m:0,0 m:62.132034,150 moving m:10,140");
  EXPECT_TRUE(words().contains("Step 3 of 5"));
  EXPECT_EQ(hub_.session().tool(), ToolId::CurveCut);

  QSignalSpy ended(&card_, &TourCard::ended);
  for (QPushButton* button : card_.findChildren<QPushButton*>()) button->click();
  EXPECT_EQ(ended.count(), 1);
  EXPECT_FALSE(card_.isVisible());
  EXPECT_FALSE(hasGhost());
}

TEST_F(TourCardTest, StaysInItsCornerWhenTheWindowChanges) {
  window_.show();
  card_.begin();
  for (const QSize size : {QSize(700, 500), QSize(1200, 800)}) {
    window_.resize(size);
    QTest::qWait(50);
    EXPECT_TRUE(window_.rect().contains(card_.geometry()));
    EXPECT_LT(window_.height() - card_.geometry().bottom(), 40);
  }
}

class RecoveryDialogTest : public test::DialogTest {};

TEST_F(RecoveryDialogTest, OffersWhatWasLeftAndDiscardsIt) {
  const std::string folder = folder_.path().toStdString();
  {
    Result<Journal> journal = Journal::open(folder);
    ASSERT_TRUE(journal.isOk());
    ASSERT_TRUE(journal->note(kiri::test::modelOf("square 100; turn; turn"), 2, "/models/leaf.kiri")
                    .isOk());
  }
  ASSERT_EQ(leftoversIn(folder).size(), 1U);
  RecoveryDialog dialog(leftoversIn(folder));
  test::show(dialog, "recovery");
  ASSERT_TRUE(dialog.chosen().has_value());
  const Result<Recovered> recovered = recover(*dialog.chosen());
  ASSERT_TRUE(recovered.isOk());
  EXPECT_EQ(recovered->model.steps.size(), 2U);
  dialog.discardChosen(false);
  EXPECT_TRUE(leftoversIn(folder).empty());
  EXPECT_FALSE(dialog.isVisible()) << "nothing is left to ask about";
}

}  // namespace
}  // namespace kiri::desktop
