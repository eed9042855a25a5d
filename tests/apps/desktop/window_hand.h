// A hand for tests of the whole window: makes one, waits for it, presses and drags in its panes.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/theme.h"
#include "apps/desktop/main_window.h"

namespace kiri::desktop {

/// Answers for the person and counts the questions.
class PreparedAnswers final : public FilePrompts {
 public:
  struct Answers {
    SaveAnswer save = SaveAnswer::Discard;
    QString toOpen;
    QString toSave;
    int asked = 0;
    QStringList problems;
  };
  explicit PreparedAnswers(Answers& answers) : answers_(answers) {}
  SaveAnswer askToSave(const QString&) override {
    ++answers_.asked;
    return answers_.save;
  }
  QString fileToOpen() override { return answers_.toOpen; }
  QString fileToSave(const QString&) override { return answers_.toSave; }
  void tellProblem(const QString&, const QString& text) override { answers_.problems << text; }

 private:
  Answers& answers_;
};

/// A window that is shown and active, and nothing of the person's own settings.
class WindowHand : public ::testing::Test {
 protected:
  void SetUp() override {
    applyTheme(*qApp, Shade::Light);
    settings = std::make_unique<Settings>();
    runner = std::make_unique<PoolRunner>();
    window = std::make_unique<MainWindow>(*runner, *settings);
    window->files().setPrompts(std::make_unique<PreparedAnswers>(answers));
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    settle();
  }
  void TearDown() override {
    window.reset();
    runner.reset();
    settings.reset();
  }

  /// Waits until nothing is being computed or painted any more.
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return runner->pending() == 0; }, 30000));
    QCoreApplication::processEvents();
    ASSERT_TRUE(QTest::qWaitFor([&] { return runner->pending() == 0; }, 30000));
    QCoreApplication::processEvents();
  }
  void open(const QString& example) {
    window->files().openFile(KIRI_SOURCE_DIR "/examples/" + example);
    settle();
  }
  Session& session() { return window->session(); }
  QWidget* model() { return window->modelView().surface(); }
  QPoint pixelOf(Vec3 place) { return toQt(session().camera().map().toPixels(place)).toPoint(); }
  /// Drags slowly enough for previews, and stays where it ends when `release` is false.
  void drag(QWidget* pane, QPoint from, QPoint to, bool release = true) {
    QTest::mouseMove(pane, from);
    QTest::mousePress(pane, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) {
      QTest::mouseMove(pane, from + (to - from) * i / 8);
      QCoreApplication::processEvents();
    }
    if (release) QTest::mouseRelease(pane, Qt::LeftButton, {}, to);
    settle();
  }
  /// A picture of the window in the folder KIRI_PICTURES, to be looked at.
  void picture(const QString& name) {
    settle();
    QTest::qWait(60);
    const QString folder = qEnvironmentVariable("KIRI_PICTURES");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    const QString scale = qApp->devicePixelRatio() > 1.5 ? "@2x" : "";
    window->grab().save(folder + "/" + name + scale + ".png");
  }

  PreparedAnswers::Answers answers;
  std::unique_ptr<Settings> settings;
  std::unique_ptr<PoolRunner> runner;
  std::unique_ptr<MainWindow> window;
};

}  // namespace kiri::desktop
