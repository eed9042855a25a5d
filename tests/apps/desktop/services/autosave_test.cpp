// The journal follows the document.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/autosave.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <string>
#include <utility>
#include <vector>

#include "apps/desktop/services/pool_runner.h"
#include "editor/document/journal.h"
#include "tests/support/model_text.h"

namespace kiri::desktop {
namespace {

class AutosaveTest : public ::testing::Test {
 protected:
  QString folder() const { return folder_.path(); }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return runner_.pending() == 0; }, 5000));
  }
  /// What another process would find if this one were killed now: the lock of the living is passed
  /// by, as the files are copied away.
  std::vector<Recovered> whatAKillWouldLeave() {
    QTemporaryDir copies;
    for (const QFileInfo& file : QDir(folder()).entryInfoList(QDir::Files | QDir::Hidden))
      QFile::copy(file.filePath(), copies.filePath(file.fileName()));
    std::vector<Recovered> found;
    for (const Leftover& leftover : leftoversIn(copies.path().toStdString()))
      found.push_back(recover(leftover).value());
    return found;
  }
  static Document document(const char* text) {
    return Document::create(test::modelOf(text)).value();
  }
  static Document changed(Document document, const char* step) {
    const Result<History> next = addStep(test::stepOf(step))(document.history(), {});
    EXPECT_TRUE(next.isOk());
    document.become(*next, {"step", {}});
    return document;
  }

  QTemporaryDir folder_;
  PoolRunner runner_;
};

TEST_F(AutosaveTest, AnUntouchedDocumentHasNoJournal) {
  Autosave autosave(runner_, folder());
  Document fresh = document("square 100");
  fresh.noteSaved();
  autosave.note(fresh);
  settle();
  EXPECT_TRUE(whatAKillWouldLeave().empty());
}

TEST_F(AutosaveTest, AStepIsOnDiskRightAfterItWasMade) {
  Autosave autosave(runner_, folder());
  Document leaf = changed(document("square 100"), "fold valley 50,0 50,100 left");
  leaf.setPath("/models/leaf.kiri");
  autosave.note(leaf);
  settle();
  const std::vector<Recovered> left = whatAKillWouldLeave();
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].model.steps.size(), 1U);
  EXPECT_EQ(left[0].originalPath, "/models/leaf.kiri");
}

TEST_F(AutosaveTest, ManyQuickStepsEndWithTheNewest) {
  Autosave autosave(runner_, folder());
  Document doc = document("square 100");
  for (int i = 1; i <= 20; ++i) {
    const std::string step = "edge 0," + std::to_string(i * 4) + " 100," + std::to_string(i * 4);
    doc = changed(std::move(doc), step.c_str());
    QElapsedTimer clock;
    clock.start();
    autosave.note(doc);
    EXPECT_LT(clock.elapsed(), 50) << "the window does not wait for the disk";
  }
  settle();
  const std::vector<Recovered> left = whatAKillWouldLeave();
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].model.steps.size(), 20U);
}

TEST_F(AutosaveTest, LookingAtAnEarlierStepTakesNoneOutOfForce) {
  Autosave autosave(runner_, folder());
  Document doc = changed(document("square 100"), "fold valley 50,0 50,100 left");
  doc = changed(std::move(doc), "turn");
  doc.jumpTo(1);
  autosave.note(doc);
  settle();
  const std::vector<Recovered> left = whatAKillWouldLeave();
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].count, 2U);
}

TEST_F(AutosaveTest, SavingAndClosingInOrderLeaveNothing) {
  Autosave autosave(runner_, folder());
  Document doc = changed(document("square 100"), "fold valley 50,0 50,100 left");
  autosave.note(doc);
  settle();
  ASSERT_EQ(whatAKillWouldLeave().size(), 1U);
  doc.noteSaved();
  autosave.note(doc);
  settle();
  EXPECT_TRUE(whatAKillWouldLeave().empty());
  doc = changed(std::move(doc), "turn");
  autosave.note(doc);  // on its way while the window closes
  autosave.finish();
  settle();
  EXPECT_TRUE(whatAKillWouldLeave().empty());
}

TEST_F(AutosaveTest, SwitchedOffItWritesNothingAndTakesAwayWhatThereWas) {
  Autosave autosave(runner_, folder());
  const Document doc = changed(document("square 100"), "fold valley 50,0 50,100 left");
  autosave.note(doc);
  settle();
  autosave.setEnabled(false);
  EXPECT_TRUE(whatAKillWouldLeave().empty());
  autosave.note(changed(doc, "turn"));
  settle();
  EXPECT_TRUE(whatAKillWouldLeave().empty());
  autosave.setEnabled(true);
  autosave.note(doc);
  settle();
  EXPECT_EQ(whatAKillWouldLeave().size(), 1U);
}

TEST_F(AutosaveTest, AFolderThatCannotBeWrittenIsToldOnce) {
  Autosave autosave(runner_, "/proc/nowhere");
  QSignalSpy failures(&autosave, &Autosave::failed);
  Document doc = document("square 100");
  for (const char* step : {"fold valley 50,0 50,100 left", "turn", "turn"}) {
    doc = changed(std::move(doc), step);
    autosave.note(doc);
    settle();
  }
  ASSERT_EQ(failures.count(), 1);
  EXPECT_TRUE(failures[0][0].toString().contains("/proc/nowhere"));
}

}  // namespace
}  // namespace kiri::desktop
