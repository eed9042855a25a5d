// The words below the panes: of the model when it is opened, of the step when it is walked.
// SPDX-License-Identifier: MIT
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

#include "apps/desktop/panels/notes_box.h"
#include "tests/apps/desktop/window_hand.h"

namespace kiri::desktop {
namespace {

class CaptionInTheWindow : public WindowHand {
 protected:
  QToolButton* button(const QString& name) {
    for (QToolButton* one : window->caption().findChildren<QToolButton*>())
      if (one->accessibleName() == name) return one;
    return nullptr;
  }
  const Model& shown() { return session().document().model(); }
};

TEST_F(CaptionInTheWindow, AnOpenedExampleIsIntroducedAndThenWalkedStepByStep) {
  open("origami_bird.kiri");
  CaptionBar& caption = window->caption();
  ASSERT_TRUE(caption.isVisible());
  EXPECT_EQ(caption.notes(), toQt(shown().notes));
  auto* start = caption.findChild<QPushButton*>();
  ASSERT_NE(start, nullptr);
  ASSERT_TRUE(start->isVisible());
  picture("caption-introduction");
  const QRect panes = window->modelView().geometry();
  QTest::mouseClick(start, Qt::LeftButton);
  settle();
  EXPECT_EQ(session().document().cursor(), 0U);
  EXPECT_FALSE(button("Previous step")->isEnabled());
  QToolButton* forward = button("Next step");
  ASSERT_NE(forward, nullptr);
  for (std::size_t step = 1; step <= shown().steps.size(); ++step) {
    QTest::mouseClick(forward, Qt::LeftButton);
    settle();
    ASSERT_EQ(session().document().cursor(), step);
    EXPECT_EQ(caption.title(), toQt(shown().steps[step - 1].title));
    EXPECT_EQ(caption.notes(), toQt(shown().steps[step - 1].notes));
    EXPECT_EQ(window->modelView().geometry(), panes) << "the panes stay where they are";
    if (step == 4) picture("caption-step");
  }
  EXPECT_FALSE(forward->isEnabled());
  EXPECT_FALSE(window->isWindowModified()) << "reading is no change";
}

TEST_F(CaptionInTheWindow, TheFilmIsToldAlong) {
  open("ship.kiri");
  window->actions()["play"].trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return session().isPlayerOpen(); }, 10000));
  session().player().pause();
  for (std::size_t step = 1; step <= shown().steps.size(); ++step) {
    session().player().seekStep(step);
    session().playerMoved();
    settle();
    EXPECT_EQ(window->caption().title(), toQt(shown().steps[step - 1].title));
  }
  QTest::mouseClick(button("Previous step"), Qt::LeftButton);
  settle();
  EXPECT_EQ(session().player().step(), shown().steps.size() - 1) << "it walks the film";
}

TEST_F(CaptionInTheWindow, ASmallWindowShowsWholeLinesAndTheCardOfTheStep) {
  open("origami_bird.kiri");
  window->resize(1024, 700);
  settle();
  auto* room = window->caption().findChild<QScrollArea*>();
  ASSERT_NE(room, nullptr);
  ASSERT_GT(room->widget()->height(), room->viewport()->height()) << "the notes are too long";
  EXPECT_EQ(room->viewport()->height() % room->widget()->fontMetrics().lineSpacing(), 0);
  const StepsList& steps = *window->docks().steps;
  const QRect card = steps.visualRect(steps.currentIndex());
  EXPECT_TRUE(steps.viewport()->rect().contains(card.center()));
  picture("caption-small");
}

TEST_F(CaptionInTheWindow, IsNotThereWithoutWordsOrWhenItIsNotWanted) {
  EXPECT_FALSE(window->caption().isVisible());
  open("ship.kiri");
  EXPECT_TRUE(window->caption().isVisible());
  window->actions()["step-notes"].trigger();
  EXPECT_FALSE(window->caption().isVisible());
  window->actions()["step-notes"].trigger();
  EXPECT_TRUE(window->caption().isVisible());
}

TEST_F(CaptionInTheWindow, NotesOfAStepAreWrittenInLines) {
  open("ship.kiri");
  auto* box = qobject_cast<NotesBox*>(window->docks().step->editor().widgetOf("notes"));
  ASSERT_NE(box, nullptr);
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "Press it flat.");
  QTest::keyClick(box, Qt::Key_Return);
  QTest::keyClicks(box, "Done.");
  EXPECT_FALSE(window->isWindowModified()) << "not while it is being typed";
  QTest::keyClick(box, Qt::Key_Return, Qt::ControlModifier);
  settle();
  EXPECT_EQ(shown().steps.back().notes, "Press it flat.\nDone.");
  session().jumpTo(1);
  settle();
  session().jumpTo(shown().steps.size());
  settle();
  EXPECT_EQ(window->caption().notes(), "Press it flat.\nDone.");
}

}  // namespace
}  // namespace kiri::desktop
