// What the hand does in a pane, from Qt's events to the session.
// SPDX-License-Identifier: MIT
#pragma once

#include <QLineF>
#include <QObject>
#include <QPointF>
#include <QWidget>

#include "editor/session/session.h"

class QMouseEvent;
class QWheelEvent;
class QKeyEvent;
class QTouchEvent;
class QNativeGestureEvent;

namespace kiri::desktop {

/// Translates the events of one pane's widget and keeps nothing of the model. The widget hands each
/// of its events to `handle` first.
class PaneInput final : public QObject {
  Q_OBJECT
 public:
  PaneInput(Session& session, Pane pane, QWidget* widget);

  /// True when the event is dealt with.
  bool handle(QEvent* event);

 private:
  bool mouse(QMouseEvent* event);
  bool wheel(QWheelEvent* event);
  bool key(QKeyEvent* event);
  bool space(QKeyEvent* event);
  bool touch(QTouchEvent* event);
  bool gesture(QNativeGestureEvent* event);
  void modifiersChanged(const QKeyEvent* event);
  void beginTouch(QPointF at);
  void dropWhatOneFingerBegan();
  void send(PointerAction action, QPointF at, PointerButton button, Qt::KeyboardModifiers keys,
            bool isTouch = false);

  /// One finger: waits until it has moved a little, for a second one may follow.
  enum class Fingers { None, Waiting, One, Two };

  Session& session_;
  Pane pane_;
  QWidget* widget_;
  QPointF last_;
  PointerButton held_ = PointerButton::None;
  Fingers fingers_ = Fingers::None;
  QPointF firstTouch_;
  QLineF pinch_;  ///< from one of two fingers to the other
  Qt::KeyboardModifiers touchKeys_;
};

}  // namespace kiri::desktop
