// The whole window, driven by mouse and keyboard.
// SPDX-License-Identifier: MIT
#include "apps/desktop/main_window.h"

#include <QAccessible>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>

#include "apps/desktop/panels/fold_row.h"
#include "apps/desktop/panels/fold_rows.h"
#include "apps/desktop/panels/unit_box.h"
#include "editor/document/new_sheet.h"
#include "tests/apps/desktop/window_hand.h"

namespace kiri::desktop {
namespace {

class Window : public WindowHand {};

TEST_F(Window, OpensTheLeafAndSaysWhatLiesThere) {
  open("leaf_palmate.kiri");
  EXPECT_TRUE(answers.problems.isEmpty()) << answers.problems.join("; ").toStdString();
  EXPECT_TRUE(window->windowTitle().startsWith("leaf_palmate.kiri"));
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_EQ(window->statusLine().facts(), "12 facets  ·  1 layer  ·  free");
  EXPECT_FALSE(window->statusLine().hint().isEmpty());
  EXPECT_EQ(window->docks().steps->model()->rowCount(),
            static_cast<int>(session().document().model().steps.size()) + 1);
  picture("leaf-light");
}

TEST_F(Window, TheFootSpeaksOfTheStartPageWhileItIsThere) {
  open("ship.kiri");
  const QString ofTheTool = window->statusLine().hint();
  const QString facts = window->statusLine().facts();
  window->dialogs().showStartPage(true);
  EXPECT_TRUE(window->statusLine().hint().contains("example"))
      << window->statusLine().hint().toStdString();
  session().setTool(ToolId::Tear);  // as a key may do
  EXPECT_TRUE(window->statusLine().hint().contains("example"));
  EXPECT_EQ(window->statusLine().facts(), "") << "the model is not seen";
  session().setTool(ToolId::Fold);
  window->dialogs().showStartPage(false);
  EXPECT_EQ(window->statusLine().hint(), ofTheTool);
  EXPECT_EQ(window->statusLine().facts(), facts);
}

TEST_F(Window, ASentenceThatIsTooLongForTheFootEndsInDots) {
  window->resize(1024, 700);
  settle();
  const QString sentence = QString("A sentence that goes on and on. ").repeated(20);
  window->statusLine().say(Notice::Kind::Done, sentence);
  settle();
  const auto* shown = window->statusLine().findChild<QLabel*>("hint");
  ASSERT_NE(shown, nullptr);
  EXPECT_EQ(window->statusLine().hint(), sentence);
  EXPECT_TRUE(shown->text().endsWith(QChar(0x2026))) << shown->text().toStdString();
  EXPECT_LE(shown->fontMetrics().horizontalAdvance(shown->text()), shown->width());
}

TEST_F(Window, SaysWhichImageOfThePaperCannotBeRead) {
  Model model = sheetPresets().front().model;
  model.front.texture = "/nowhere/bark.png";
  window->files().openModel(model);
  EXPECT_TRUE(QTest::qWaitFor(
      [this] { return window->statusLine().hint().contains("/nowhere/bark.png"); }, 5000))
      << window->statusLine().hint().toStdString();
}

TEST_F(Window, BothPanesShowThePaperInItsColours) {
  open("leaf_palmate.kiri");
  QTest::qWait(100);
  const QImage model = window->modelView().grab().toImage();
  const QImage sheet = window->sheetView().grab().toImage();
  const auto countLike = [](const QImage& image, QColor wanted) {
    int count = 0;
    for (int y = 0; y < image.height(); y += 3) {
      for (int x = 0; x < image.width(); x += 3) {
        const QColor c = image.pixelColor(x, y);
        const int apart = std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) +
                          std::abs(c.blue() - wanted.blue());
        count += apart < 60 ? 1 : 0;
      }
    }
    return count * 100 / std::max(1, image.width() * image.height() / 9);
  };
  const QColor front = toQt(session().document().model().front.color);
  EXPECT_GT(countLike(model, front), 10) << "percent of the pane in the colour of the paper";
  EXPECT_GT(countLike(model, theme().ground), 30);
  EXPECT_GT(countLike(sheet, theme().sheetGround), 30);
}

TEST_F(Window, DraggingACornerOntoTheOppositeOneFoldsTheSheet) {
  const auto before = session().document().model().steps.size();
  drag(model(), pixelOf({150, 150, 0}), pixelOf({0, 0, 0}));
  EXPECT_TRUE(session().canCommit());
  picture("fold-preview");
  ASSERT_NE(window->fieldBar().editor().widgetOf("angle"), nullptr);
  QTest::keyClick(model(), Qt::Key_Return);
  settle();
  EXPECT_EQ(session().document().model().steps.size(), before + 1);
  EXPECT_EQ(session().facts().facets, 2U);
  EXPECT_TRUE(window->isWindowModified());
  picture("fold-done");
}

TEST_F(Window, AnAngleTypedInTheBarIsTheAngleOfTheFold) {
  drag(model(), pixelOf({150, 150, 0}), pixelOf({0, 0, 0}));
  auto* box = qobject_cast<UnitBox*>(window->fieldBar().editor().widgetOf("angle"));
  ASSERT_NE(box, nullptr);
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "120");
  settle();
  picture("fold-120");
  QTest::keyClick(box, Qt::Key_Return);
  settle();
  ASSERT_EQ(session().document().model().steps.size(), 1U);
  const auto* fold = std::get_if<FoldStep>(&session().document().model().steps[0].action);
  ASSERT_NE(fold, nullptr);
  EXPECT_DOUBLE_EQ(fold->angle, 120);
}

TEST_F(Window, OneFingerFolds) {
  static QPointingDevice* finger = QTest::createTouchDevice();
  const QPoint from = pixelOf({150, 150, 0});
  const QPoint to = pixelOf({0, 0, 0});
  QTest::touchEvent(model(), finger).press(0, from, model());
  for (int i = 1; i <= 6; ++i) {
    QTest::touchEvent(model(), finger).move(0, from + (to - from) * i / 6, model());
  }
  QTest::touchEvent(model(), finger).release(0, to, model());
  settle();
  EXPECT_TRUE(session().canCommit());
}

TEST_F(Window, TwoFingersZoomAndFoldNothing) {
  static QPointingDevice* fingers = QTest::createTouchDevice();
  const QPoint middle = model()->rect().center();
  const double before = session().camera().map().pixelsPerMm;
  const auto at = [&](int apart) { return QPoint(apart, 0); };
  QTest::touchEvent(model(), fingers).press(0, middle - at(40), model());
  QTest::touchEvent(model(), fingers).stationary(0).press(1, middle + at(40), model());
  for (int apart = 40; apart <= 80; apart += 10) {
    QTest::touchEvent(model(), fingers)
        .move(0, middle - at(apart), model())
        .move(1, middle + at(apart), model());
  }
  QTest::touchEvent(model(), fingers)
      .release(0, middle - at(80), model())
      .release(1, middle + at(80), model());
  settle();
  EXPECT_NEAR(session().camera().map().pixelsPerMm / before, 2, 0.1);
  EXPECT_FALSE(session().canCommit());
}

TEST_F(Window, EscapeDropsWhatIsHalfDone) {
  drag(model(), pixelOf({150, 150, 0}), pixelOf({0, 0, 0}));
  ASSERT_TRUE(session().canCommit());
  QTest::keyClick(model(), Qt::Key_Escape);
  settle();
  EXPECT_FALSE(session().canCommit());
  EXPECT_TRUE(session().document().model().steps.empty());
}

TEST_F(Window, KeysTakeUpTools) {
  const std::pair<Qt::Key, ToolId> keys[] = {
      {Qt::Key_L, ToolId::Line},     {Qt::Key_T, ToolId::Tear},    {Qt::Key_C, ToolId::StraightCut},
      {Qt::Key_B, ToolId::CurveCut}, {Qt::Key_A, ToolId::AddEdge}, {Qt::Key_S, ToolId::Select},
      {Qt::Key_F, ToolId::Fold}};
  for (const auto& [key, tool] : keys) {
    QTest::keyClick(model(), key);
    EXPECT_EQ(session().tool(), tool);
  }
}

TEST_F(Window, LettersTypedIntoANameTakeUpNoTool) {
  drag(model(), pixelOf({150, 150, 0}), pixelOf({0, 0, 0}));
  QWidget* name = window->fieldBar().editor().widgetOf("name");
  ASSERT_NE(name, nullptr);
  name->setFocus();
  QTest::keyClicks(name, "btl");
  EXPECT_EQ(session().tool(), ToolId::Fold);
  QTest::keyClick(name, Qt::Key_Return);
  settle();
  ASSERT_EQ(session().document().model().steps.size(), 1U);
  EXPECT_EQ(std::get<FoldStep>(session().document().model().steps[0].action).name, "btl");
}

TEST_F(Window, UndoAndRedoByKeysWalkTheHistory) {
  QTest::keyClick(model(), Qt::Key_X);
  settle();
  ASSERT_EQ(session().document().cursor(), 1U);
  QTest::keyClick(model(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_EQ(session().document().cursor(), 0U);
  QTest::keyClick(model(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  settle();
  EXPECT_EQ(session().document().cursor(), 1U);
  QTest::keyClick(model(), Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(model(), Qt::Key_Y, Qt::ControlModifier);
  settle();
  EXPECT_EQ(session().document().cursor(), 1U);
}

TEST_F(Window, AClickOnACardShowsTheModelThere) {
  open("leaf_palmate.kiri");
  StepsList* steps = window->docks().steps;
  const QModelIndex third = steps->model()->index(3, 0);
  steps->scrollTo(third);
  QTest::mouseClick(steps->viewport(), Qt::LeftButton, {}, steps->visualRect(third).center());
  settle();
  EXPECT_EQ(session().document().cursor(), 3U);
  EXPECT_FALSE(window->isWindowModified()) << "looking is no change";
  picture("leaf-step-3");
}

TEST_F(Window, EditingAnEarlierStepReplaysWhatFollows) {
  open("ship.kiri");
  session().jumpTo(1);
  settle();
  FieldEditor& editor = window->docks().step->editor();
  auto* angle = qobject_cast<UnitBox*>(editor.widgetOf("angle"));
  ASSERT_NE(angle, nullptr);
  angle->setFocus();
  angle->selectAll();
  QTest::keyClicks(angle, "90");
  QTest::keyClick(angle, Qt::Key_Return);
  settle();
  EXPECT_DOUBLE_EQ(std::get<FoldStep>(session().document().model().steps[0].action).angle, 90);
  EXPECT_TRUE(window->isWindowModified());
}

TEST_F(Window, ASliderMovesThePaperAndLettingGoMakesOneStep) {
  drag(model(), pixelOf({150, 150, 0}), pixelOf({0, 0, 0}));
  QTest::keyClick(model(), Qt::Key_Return);
  settle();
  FoldRow* row = window->docks().folds->rows().rowOf(0);
  ASSERT_NE(row, nullptr);
  QSlider* bar = row->bar();
  bar->setSliderDown(true);
  bar->setValue(900);
  settle();
  ASSERT_TRUE(session().slideShow().has_value());
  EXPECT_NEAR(session().slideShow()->amount, 90, 0.1);
  window->actions()["view-angled"].trigger();
  picture("slide-90");
  bar->setSliderDown(false);
  settle();
  EXPECT_EQ(session().document().model().steps.size(), 2U);
  EXPECT_FALSE(session().slideShow().has_value());
}

TEST_F(Window, ClosingAsksAboutUnsavedChangesAndCancelKeepsTheWindow) {
  QTest::keyClick(model(), Qt::Key_X);
  settle();
  answers.save = SaveAnswer::Cancel;
  EXPECT_FALSE(window->close());
  EXPECT_EQ(answers.asked, 1);
  EXPECT_TRUE(window->isVisible());
  answers.save = SaveAnswer::Discard;
  window->close();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !window->isVisible(); }));
}

TEST_F(Window, SavingOnTheWayOutWritesTheFileAndCloses) {
  const QTemporaryDir folder;
  QTest::keyClick(model(), Qt::Key_X);
  settle();
  answers.save = SaveAnswer::Save;
  answers.toSave = folder.filePath("turned.kiri");
  window->close();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !window->isVisible(); }));
  QFile file(answers.toSave);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("turn over"));
}

TEST_F(Window, WhatWasSavedOpensAgainAsItWas) {
  const QTemporaryDir folder;
  drag(model(), pixelOf({150, 150, 0}), pixelOf({0, 0, 0}));
  QTest::keyClick(model(), Qt::Key_Return);
  settle();
  answers.toSave = folder.filePath("fold.kiri");
  QTest::keyClick(model(), Qt::Key_S, Qt::ControlModifier);
  settle();
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(window->windowTitle().startsWith("fold.kiri"));
  window->files().openModel(Model{});
  settle();
  EXPECT_TRUE(session().document().model().steps.empty());
  window->files().openFile(answers.toSave);
  settle();
  EXPECT_EQ(session().document().model().steps.size(), 1U);
  EXPECT_TRUE(settings->recentFiles().contains(answers.toSave));
}

TEST_F(Window, AFileThatCannotBeReadIsToldAndNothingIsLost) {
  QTest::keyClick(model(), Qt::Key_X);
  settle();
  answers.save = SaveAnswer::Discard;
  window->files().openFile("/no/such/file.kiri");
  settle();
  EXPECT_EQ(answers.problems.size(), 1);
  EXPECT_EQ(session().document().model().steps.size(), 1U);
}

TEST_F(Window, AFileThatIsDroppedIsOpened) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(KIRI_SOURCE_DIR "/examples/ship.kiri")});
  QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &drop);
  settle();
  EXPECT_TRUE(window->windowTitle().startsWith("ship.kiri"));
}

TEST_F(Window, OneOfThePanesIsAlwaysThere) {
  QTest::keyClick(model(), Qt::Key_3);
  EXPECT_FALSE(window->modelView().isVisible());
  EXPECT_TRUE(window->sheetView().isVisible());
  picture("sheet-only");
  window->actions()["show-sheet"].trigger();
  EXPECT_TRUE(window->modelView().isVisible());
  EXPECT_FALSE(window->sheetView().isVisible());
  window->actions()["show-model"].trigger();
  EXPECT_TRUE(window->sheetView().isVisible());
}

TEST_F(Window, PlaysTheProcessAndComesBack) {
  open("ship.kiri");
  window->actions()["play"].trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return session().isPlayerOpen(); }, 10000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return session().player().seconds() > 0.2; }, 10000));
  EXPECT_TRUE(window->docks().player->isPlaying());
  window->docks().player->slider().setValue(400);
  EXPECT_FALSE(session().player().isPlaying()) << "scrubbing holds the film";
  EXPECT_NEAR(session().player().seconds(), 4, 0.01);
  picture("film");
  window->actions()["stop"].trigger();
  settle();
  EXPECT_FALSE(session().isPlayerOpen());
  EXPECT_EQ(session().document().cursor(), session().document().model().steps.size());
}

TEST_F(Window, SpaceTappedPlaysAndHolds) {
  open("ship.kiri");
  QTest::keyClick(model(), Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->docks().player->isPlaying(); }, 10000));
  QTest::keyClick(model(), Qt::Key_Space);
  settle();
  EXPECT_TRUE(session().isPlayerOpen());
  EXPECT_FALSE(window->docks().player->isPlaying());
}

TEST_F(Window, ChangedShortcutsWorkAtOnce) {
  settings->setShortcuts({{"tear", {QKeySequence("K")}}});
  QTest::keyClick(model(), Qt::Key_K);
  EXPECT_EQ(session().tool(), ToolId::Tear);
  settings->setShortcuts({});
}

TEST_F(Window, EverythingThatTakesTheFocusHasANameOrText) {
  open("leaf_palmate.kiri");
  for (QWidget* widget : window->findChildren<QWidget*>()) {
    if (widget->focusProxy() || widget->focusPolicy() == Qt::NoFocus || !widget->isVisible() ||
        !widget->isEnabled()) {
      continue;
    }
    QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(reader, nullptr);
    const bool isNamed = !reader->text(QAccessible::Name).isEmpty();
    const bool isScrolling = widget->inherits("QAbstractScrollArea");
    EXPECT_TRUE(isNamed || isScrolling)
        << widget->metaObject()->className() << " " << widget->objectName().toStdString();
  }
}

TEST_F(Window, LooksRightInTheDark) {
  open("ship.kiri");
  applyTheme(*qApp, Shade::Dark);
  QTest::qWait(100);
  const QColor ground = window->modelView().grab().toImage().pixelColor(5, 5);
  EXPECT_LT(ground.lightness(), 80);
  picture("ship-dark");
  applyTheme(*qApp, Shade::Light);
  QTest::qWait(100);
  EXPECT_GT(window->modelView().grab().toImage().pixelColor(5, 5).lightness(), 200);
}

}  // namespace
}  // namespace kiri::desktop
