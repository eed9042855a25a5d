// A person at the real window: mouse and keyboard only, on a screen that nobody sees.
// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QTemporaryDir>
#include <map>
#include <string>
#include <vector>

#include "tests/apps/desktop/window_hand.h"
#include "tests/editor/session/journeys.h"

namespace kiri::desktop {

/// Journeys go by keys and by the mouse in the panes; what a menu alone offers is triggered as the
/// menu does. Screenshots of a failed journey are kept in the folder KIRI_SCREENSHOTS, or beside
/// the program.
class Journey : public WindowHand, public test::Person {
 protected:
  void TearDown() override {
    if (HasFailure() && window) keepScreenshot();
    WindowHand::TearDown();
  }

  Session& session() override { return WindowHand::session(); }
  void take(ToolId tool) override {
    static const std::map<ToolId, Qt::Key> keys = {
        {ToolId::Fold, Qt::Key_F},        {ToolId::Line, Qt::Key_L},
        {ToolId::Angle, Qt::Key_W},       {ToolId::AddEdge, Qt::Key_A},
        {ToolId::Tear, Qt::Key_T},        {ToolId::Mend, Qt::Key_E},
        {ToolId::StraightCut, Qt::Key_C}, {ToolId::CurveCut, Qt::Key_B},
        {ToolId::Select, Qt::Key_S},      {ToolId::Measure, Qt::Key_R},
        {ToolId::TopLayer, Qt::Key_O}};
    type(keys.at(tool));
    ASSERT_EQ(session().tool(), tool) << "the key of the tool does not take it up";
  }
  void drag(Pane pane, Vec2 from, Vec2 to, bool isFree = false) override {
    QWidget* widget = paneOf(pane);
    const QPoint start = pixel(pane, from);
    const QPoint end = pixel(pane, to);
    QTest::mouseMove(widget, start);
    QTest::mousePress(widget, Qt::LeftButton, held_, start);
    const Qt::KeyboardModifiers held = isFree ? Qt::ControlModifier : held_;
    for (int i = 1; i <= 6; ++i) move(widget, start + (end - start) * i / 6, held);
    QTest::mouseRelease(widget, Qt::LeftButton, held, end);
    settle();
  }
  /// One stroke of the mouse through places, as they are: snaps are suspended.
  void stroke(Pane pane, const std::vector<Vec2>& places) {
    QWidget* widget = paneOf(pane);
    const QPoint start = pixel(pane, places.front());
    QTest::mouseMove(widget, start);
    QTest::mousePress(widget, Qt::LeftButton, Qt::ControlModifier, start);
    for (const Vec2 place : places) move(widget, pixel(pane, place), Qt::ControlModifier);
    QTest::mouseRelease(widget, Qt::LeftButton, Qt::ControlModifier, pixel(pane, places.back()));
    settle();
  }
  void click(Pane pane, Vec2 at) override {
    QTest::mouseMove(paneOf(pane), pixel(pane, at));
    QTest::mouseClick(paneOf(pane), Qt::LeftButton, held_, pixel(pane, at));
    QCoreApplication::processEvents();
    settle();
  }
  void press(Key key) override {
    static const std::map<Key, Qt::Key> keys = {{Key::Enter, Qt::Key_Return},
                                                {Key::Escape, Qt::Key_Escape},
                                                {Key::Tab, Qt::Key_Tab},
                                                {Key::Delete, Qt::Key_Delete},
                                                {Key::Space, Qt::Key_Space}};
    type(keys.at(key));
  }
  void press(char key) override { type(static_cast<Qt::Key>(Qt::Key_A + (key - 'a'))); }
  void set(const std::string& field, double value) override {
    session().setField(field, {value, {}});
    settle();
  }
  void command(const std::string& name) override {
    window->actions()[QString::fromStdString(name)].trigger();
    settle();
  }
  void wait() override { settle(); }
  void holdControl(bool isHeld) override { held_ = isHeld ? Qt::ControlModifier : Qt::NoModifier; }

  void fresh(double side) {
    Model model;
    model.sheet.width = side;
    model.sheet.height = side;
    window->files().openModel(model);
    settle();
    session().fitAll();
    settle();
  }
  QWidget* paneOf(Pane pane) {
    return pane == Pane::Model ? model() : static_cast<QWidget*>(&window->sheetView());
  }
  QPoint pixel(Pane pane, Vec2 mm) {
    const PaneMap map =
        pane == Pane::Model ? session().camera().map() : session().sheetCamera().map();
    return toQt(map.toPixels(Vec3{mm.x, mm.y, 0})).toPoint();
  }
  void type(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    model()->setFocus();
    QTest::keyClick(model(), key, modifiers);
    settle();
  }
  /// The part of the model pane's pixels, 0 to 1, that differ from the exact picture of the same
  /// flat state; those within two pixels of a border of colours are not looked at, for there the
  /// window draws lines.
  double differenceFromExactPicture();

  std::size_t count() { return session().document().count(); }

 private:
  void move(QWidget* widget, QPoint to, Qt::KeyboardModifiers held) {
    QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(QPointF(to)), Qt::NoButton,
                      Qt::LeftButton, held);
    QCoreApplication::sendEvent(widget, &event);
    QCoreApplication::processEvents();
  }
  void keepScreenshot() {
    QString folder = qEnvironmentVariable("KIRI_SCREENSHOTS");
    if (folder.isEmpty()) folder = QCoreApplication::applicationDirPath() + "/screenshots";
    QDir().mkpath(folder);
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    window->grab().save(folder + "/" + info->name() + ".png");
  }

  Qt::KeyboardModifiers held_ = Qt::NoModifier;
};

}  // namespace kiri::desktop
