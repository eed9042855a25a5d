// Crease patterns in the real window: opened, pasted, dropped, walked, folded on, saved.
// SPDX-License-Identifier: MIT
#include <QClipboard>
#include <QElapsedTimer>
#include <QFile>
#include <QListWidget>
#include <QMimeData>
#include <QToolButton>
#include <QTreeWidget>

#include "core/paper/boxes.h"
#include "tests/apps/desktop/journeys/journey.h"
#include "tests/editor/session/pattern_texts.h"

namespace kiri::desktop {
namespace {

class PatternJourney : public Journey {
 protected:
  QString write(const QString& name, const std::string& text) {
    const QString path = folder.filePath(name);
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text.c_str(), static_cast<qint64>(text.size()));
    return path;
  }
  static QByteArray bytesOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
  }
  void openPattern(const QString& name, const std::string& text) {
    window->files().openFile(write(name, text));
    settle();
    EXPECT_TRUE(answers.problems.isEmpty()) << answers.problems.join("; ").toStdString();
  }
  PatternPanel& panel() { return *window->docks().pattern; }
  std::vector<FacetId> order() {
    return session().document().state()->layers.sets().front().upward;
  }
  QToolButton* button(int component, const char* name) {
    QTreeWidget& list = panel().components();
    return list.itemWidget(list.topLevelItem(component), 2)->findChild<QToolButton*>(name);
  }

  QTemporaryDir folder;
};

TEST_F(PatternJourney, AMapIsOpenedWalkedFoldedOnUndoneSavedAndOpenedAgain) {
  openPattern("map.fold", test::kMap);
  ASSERT_EQ(count(), 1u);
  EXPECT_TRUE(panel().isVisible()) << "the panel comes to the front";
  EXPECT_EQ(panel().verdict(), "The pattern folds flat.");
  EXPECT_EQ(panel().total(), "8 folded states");
  ASSERT_EQ(panel().components().topLevelItemCount(), 1);
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(window->windowTitle().startsWith("Map")) << window->windowTitle().toStdString();
  EXPECT_TRUE(settings->recentFiles().first().endsWith("map.fold"));

  const std::vector<FacetId> first = order();
  type(Qt::Key_PageDown);
  EXPECT_NE(order(), first);
  const std::vector<FacetId> second = order();
  button(0, "next")->click();
  settle();
  EXPECT_NE(order(), second);
  button(0, "previous")->click();
  settle();
  EXPECT_EQ(order(), second);
  EXPECT_EQ(count(), 1u) << "the step of the pattern is changed, none is added";
  EXPECT_LT(differenceFromExactPicture(), 0.02) << "the folded state that is shown is the chosen";
  picture("journey-map");

  take(ToolId::Line);
  const ModelBox box = modelBoxOf(*session().document().state());
  const double x = box.low.x + 20;
  drag(Pane::Model, {x, box.low.y - 5}, {x, box.high.y + 5});
  press(Key::Enter);
  ASSERT_EQ(count(), 2u) << session().notice().why;
  EXPECT_GT(session().document().state()->pattern.facets.size(), 4u);
  while (session().document().canUndo()) type(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(count(), 0u);
  while (session().document().canRedo()) type(Qt::Key_Y, Qt::ControlModifier);
  ASSERT_EQ(count(), 2u);

  const QByteArray pattern = bytesOf(folder.filePath("map.fold"));
  answers.toSave = folder.filePath("map.fold");
  command("save");
  EXPECT_EQ(answers.problems.size(), 1) << "a pattern is not overwritten by a model";
  EXPECT_EQ(bytesOf(folder.filePath("map.fold")), pattern);
  answers.problems.clear();
  answers.toSave = folder.filePath("map.kiri");
  command("save");
  EXPECT_FALSE(window->isWindowModified());
  const std::vector<FacetId> saved = order();
  fresh(100);
  window->files().openFile(folder.filePath("map.kiri"));
  settle();
  ASSERT_EQ(count(), 2u);
  EXPECT_EQ(order(), saved);
  EXPECT_EQ(panel().total(), "8 folded states");
}

TEST_F(PatternJourney, WhatLiesOnTopIsPickedByClicking) {
  openPattern("map.fold", test::kMap);
  take(ToolId::TopLayer);
  const ModelBox box = modelBoxOf(*session().document().state());
  const Vec2 middle{box.middle().x, box.middle().y};
  const std::vector<FacetId> before = order();
  click(Pane::Model, middle);
  click(Pane::Model, middle);
  EXPECT_FALSE(session().fields().empty());
  picture("journey-on-top");
  const FacetId wanted = before[before.size() - 3];
  press(Key::Enter);
  EXPECT_EQ(order().back(), wanted) << session().notice().why;
  // In the sheet the other layers of the place are clicked themselves.
  click(Pane::Model, middle);
  click(Pane::Sheet, {25, 25});
  const auto corner = facetAt(session().document().state()->pattern, {25, 25});
  EXPECT_EQ(order().back(), *corner) << session().notice().why;
  EXPECT_EQ(count(), 1u);
}

TEST_F(PatternJourney, ABrokenPatternShowsItsFaults) {
  openPattern("broken.fold", test::kBroken);
  EXPECT_TRUE(panel().verdict().startsWith("The pattern does not fold flat."));
  ASSERT_GE(panel().faults().count(), 1);
  panel().faults().setCurrentRow(0);
  settle();
  const QPointF at = toQt(session().sheetCamera().map().toPixels(Vec3{50, 50, 0}));
  EXPECT_NEAR(at.x(), window->sheetView().width() / 2.0, 1) << "the sheet moved to the fault";
  EXPECT_NEAR(at.y(), window->sheetView().height() / 2.0, 1);
  picture("journey-faults");
  applyTheme(*qApp, Shade::Dark);
  picture("journey-faults-dark");
  applyTheme(*qApp, Shade::Light);
}

TEST_F(PatternJourney, APatternIsPastedAndDropped) {
  QApplication::clipboard()->setText(test::kPreliminaryBase);
  type(Qt::Key_V, Qt::ControlModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return count() == 1; }, 5000));
  settle();
  EXPECT_EQ(panel().verdict(), "The pattern folds flat.");
  EXPECT_TRUE(isFlat(*session().document().state()));
  const ModelBox box = modelBoxOf(*session().document().state());
  EXPECT_NEAR((box.high.x - box.low.x) * (box.high.y - box.low.y), 2500, 1e-6)
      << "the base is a quarter of the sheet";

  QMimeData dropped;
  dropped.setUrls({QUrl::fromLocalFile(write("accordion.fold", test::kAccordion))});
  QDropEvent event({200, 200}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &event);
  settle();
  EXPECT_EQ(panel().total(), "1 folded state");
  QApplication::clipboard()->setText("no pattern at all");
  type(Qt::Key_V, Qt::ControlModifier);
  EXPECT_TRUE(window->statusLine().hint().contains("clipboard"))
      << window->statusLine().hint().toStdString();
  EXPECT_EQ(panel().total(), "1 folded state") << "what is open stays";
}

TEST_F(PatternJourney, ALargePatternDoesNotFreezeTheWindow) {
  const QString path = write("miura.fold", test::gridText(34, 34, 5, 2, false));
  QElapsedTimer clock;
  qint64 last = 0;
  qint64 longest = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    longest = std::max(longest, clock.elapsed() - last);
    last = clock.elapsed();
  });
  clock.start();
  timer.start(5);
  window->files().openFile(path);
  settle();
  RecordProperty("longest_ms", static_cast<int>(longest));
  EXPECT_TRUE(answers.problems.isEmpty()) << answers.problems.join("; ").toStdString();
  ASSERT_EQ(count(), 1u);
  EXPECT_EQ(session().document().state()->pattern.facets.size(), 34u * 34u);
  EXPECT_EQ(panel().verdict(), "The pattern folds flat.");
  EXPECT_LT(longest, 1500) << "ms without an event";
  picture("journey-miura");
}

TEST_F(PatternJourney, ManyStatesAreCountedAndCanBeStopped) {
  openPattern("map4.fold", test::gridText(4, 4, 25, 0, true));
  EXPECT_EQ(panel().total(), "300,608 folded states");
  for (int i = 0; i < 3; ++i) type(Qt::Key_PageDown);
  EXPECT_EQ(count(), 1u);
  picture("journey-pattern");
}

}  // namespace
}  // namespace kiri::desktop
