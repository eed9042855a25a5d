// What the hand does in a pane, from Qt's events to the session.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/pane_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QTouchEvent>
#include <QWheelEvent>
#include <cmath>

#include "apps/desktop/look/convert.h"

namespace kiri::desktop {
namespace {

constexpr double kUnitsPerNotch = 120;  // QWheelEvent: eighths of a degree, 15 degrees a notch
constexpr double kPixelsPerNotch = 50;  // of a trackpad, that zoom as much as a notch
constexpr double kFingerSlack = 6;      // pixels that a finger may tremble before it draws

Modifiers modifiersOf(Qt::KeyboardModifiers keys) {
  return {.shift = keys.testFlag(Qt::ShiftModifier),
          .control = keys.testFlag(Qt::ControlModifier),
          .alt = keys.testFlag(Qt::AltModifier)};
}

PointerButton buttonOf(Qt::MouseButton button) {
  switch (button) {
    case Qt::LeftButton:
      return PointerButton::Left;
    case Qt::MiddleButton:
      return PointerButton::Middle;
    case Qt::RightButton:
      return PointerButton::Right;
    default:
      return PointerButton::None;
  }
}

/// The editor's name of a key; false: it has none.
bool keyOf(const QKeyEvent& event, KeyEvent& out) {
  switch (event.key()) {
    case Qt::Key_Escape:
      out.key = Key::Escape;
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      out.key = Key::Enter;
      return true;
    case Qt::Key_Delete:
      out.key = Key::Delete;
      return true;
    case Qt::Key_Backspace:
      out.key = Key::Backspace;
      return true;
    case Qt::Key_Insert:
      out.key = Key::Insert;
      return true;
    case Qt::Key_Tab:
      out.key = Key::Tab;
      return true;
    case Qt::Key_Left:
      out.key = Key::Left;
      return true;
    case Qt::Key_Right:
      out.key = Key::Right;
      return true;
    case Qt::Key_Up:
      out.key = Key::Up;
      return true;
    case Qt::Key_Down:
      out.key = Key::Down;
      return true;
    case Qt::Key_Space:
      out.key = Key::Space;
      return true;
    default:
      break;
  }
  if (event.key() <= Qt::Key_Space || event.key() > Qt::Key_AsciiTilde) return false;
  out.key = Key::Character;
  const QChar character = event.text().isEmpty() || event.text()[0].unicode() <= ' '
                              ? QChar(event.key())
                              : event.text()[0];
  out.character = character.toLower().toLatin1();
  return out.character != 0;
}

bool isModifier(int key) {
  return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt;
}

}  // namespace

PaneInput::PaneInput(Session& session, Pane pane, QWidget* widget)
    : QObject(widget), session_(session), pane_(pane), widget_(widget) {
  widget->setMouseTracking(true);
  widget->setFocusPolicy(Qt::StrongFocus);
  widget->setAttribute(Qt::WA_AcceptTouchEvents);
}

bool PaneInput::handle(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
      return mouse(static_cast<QMouseEvent*>(event));
    case QEvent::Leave:
      send(PointerAction::Leave, last_, PointerButton::None, {});
      return false;
    case QEvent::Wheel:
      return wheel(static_cast<QWheelEvent*>(event));
    case QEvent::ShortcutOverride: {
      const auto* key = static_cast<QKeyEvent*>(event);
      // Held it pans, so the press and its end are wanted, not a shortcut.
      const bool isSpace = key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier;
      if (isSpace) event->accept();
      return isSpace;
    }
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return key(static_cast<QKeyEvent*>(event));
    case QEvent::Resize:
      session_.resize(
          pane_, {static_cast<double>(widget_->width()), static_cast<double>(widget_->height())});
      return false;
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      return touch(static_cast<QTouchEvent*>(event));
    case QEvent::NativeGesture:
      return gesture(static_cast<QNativeGestureEvent*>(event));
    default:
      return false;
  }
}

void PaneInput::send(PointerAction action, QPointF at, PointerButton button,
                     Qt::KeyboardModifiers keys, bool isTouch) {
  last_ = at;
  session_.pointer({.action = action,
                    .pane = pane_,
                    .at = toVec2(at),
                    .button = button,
                    .modifiers = modifiersOf(keys),
                    .isTouch = isTouch});
}

bool PaneInput::mouse(QMouseEvent* event) {
  if (event->source() != Qt::MouseEventNotSynthesized) return true;  // of fingers: see touch
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
      const PointerButton button = buttonOf(event->button());
      if (button == PointerButton::None) return false;
      held_ = button;
      const bool isDouble = event->type() == QEvent::MouseButtonDblClick;
      send(isDouble ? PointerAction::DoubleClick : PointerAction::Press, event->position(), button,
           event->modifiers());
      return true;
    }
    case QEvent::MouseButtonRelease: {
      const PointerButton button = buttonOf(event->button());
      if (button == PointerButton::None) return false;
      held_ = PointerButton::None;
      send(PointerAction::Release, event->position(), button, event->modifiers());
      return true;
    }
    default:
      send(PointerAction::Move, event->position(), held_, event->modifiers());
      return true;
  }
}

bool PaneInput::wheel(QWheelEvent* event) {
  const QPoint angle = event->angleDelta();
  const QPoint pixels = event->pixelDelta();
  // With Alt held some systems turn the wheel sideways.
  double notches = (angle.y() != 0 ? angle.y() : angle.x()) / kUnitsPerNotch;
  if (!pixels.isNull() && event->phase() != Qt::NoScrollPhase) {
    notches = pixels.y() / kPixelsPerNotch;
  }
  if (notches != 0) {
    session_.wheel({pane_, toVec2(event->position()), notches, modifiersOf(event->modifiers())});
  }
  return true;
}

bool PaneInput::space(QKeyEvent* event) {
  if (event->isAutoRepeat()) return true;
  const bool isPress = event->type() == QEvent::KeyPress;
  KeyEvent out;
  out.key = Key::Space;
  out.modifiers = modifiersOf(event->modifiers());
  out.isPress = isPress;
  session_.key(out);
  return true;
}

bool PaneInput::key(QKeyEvent* event) {
  if (isModifier(event->key())) {
    modifiersChanged(event);
    return false;
  }
  if (event->key() == Qt::Key_Space) return space(event);
  if (event->isAutoRepeat() && event->type() == QEvent::KeyRelease) return true;
  KeyEvent out;
  if (!keyOf(*event, out)) return false;
  out.modifiers = modifiersOf(event->modifiers());
  out.isPress = event->type() == QEvent::KeyPress;
  return session_.key(out);
}

/// Pressing Shift changes what a tool means without the mouse having moved: it is told all the
/// same.
void PaneInput::modifiersChanged(const QKeyEvent* event) {
  if (!widget_->underMouse() && held_ == PointerButton::None) return;
  Qt::KeyboardModifiers keys = event->modifiers();
  const Qt::KeyboardModifier own = event->key() == Qt::Key_Shift     ? Qt::ShiftModifier
                                   : event->key() == Qt::Key_Control ? Qt::ControlModifier
                                                                     : Qt::AltModifier;
  keys.setFlag(own, event->type() == QEvent::KeyPress);
  send(PointerAction::Move, last_, held_, keys);
}

void PaneInput::dropWhatOneFingerBegan() {
  KeyEvent escape;
  escape.key = Key::Escape;
  session_.key(escape);
}

void PaneInput::beginTouch(QPointF at) {
  fingers_ = Fingers::One;
  send(PointerAction::Press, firstTouch_, PointerButton::Left, touchKeys_, true);
  if (at != firstTouch_) send(PointerAction::Move, at, PointerButton::Left, touchKeys_, true);
}

bool PaneInput::touch(QTouchEvent* event) {
  event->accept();
  touchKeys_ = event->modifiers();
  const auto& points = event->points();
  if (event->type() == QEvent::TouchCancel) {
    if (fingers_ == Fingers::One) dropWhatOneFingerBegan();
    fingers_ = Fingers::None;
    return true;
  }
  if (event->type() == QEvent::TouchBegin && !points.isEmpty()) {
    firstTouch_ = points.front().position();
    fingers_ = Fingers::Waiting;
  }
  if (points.size() >= 2) {
    // What one finger began is dropped, for the hand meant something else.
    if (fingers_ == Fingers::One) dropWhatOneFingerBegan();
    const QLineF now(points[0].position(), points[1].position());
    // Not QEventPoint::lastPosition: when a finger is lifted it tells the movement before again.
    if (fingers_ == Fingers::Two && now.length() > 1 && pinch_.length() > 1) {
      const double turn = std::remainder(now.angle() - pinch_.angle(), 360.0);
      session_.pinch(pane_, toVec2(now.center()), now.length() / pinch_.length(),
                     toVec2(now.center() - pinch_.center()), turn);
    }
    // Counts from the first movement: where a resting finger is when the other lands is not sure.
    const bool hasLanded =
        points[0].state() == QEventPoint::Pressed || points[1].state() == QEventPoint::Pressed;
    pinch_ = hasLanded ? QLineF() : now;
    fingers_ = Fingers::Two;
  } else if (points.size() == 1 && fingers_ != Fingers::Two) {
    const QPointF at = points.front().position();
    const bool hasMoved = QLineF(firstTouch_, at).length() > kFingerSlack;
    if (fingers_ == Fingers::Waiting && hasMoved) {
      beginTouch(at);
    } else if (fingers_ == Fingers::One && event->type() == QEvent::TouchUpdate) {
      send(PointerAction::Move, at, PointerButton::Left, touchKeys_, true);
    }
  }
  if (event->type() == QEvent::TouchEnd) {
    if (fingers_ == Fingers::Waiting) beginTouch(firstTouch_);
    if (fingers_ == Fingers::One) {
      const QPointF at = points.isEmpty() ? last_ : points.front().position();
      send(PointerAction::Release, at, PointerButton::Left, touchKeys_, true);
    }
    fingers_ = Fingers::None;
  }
  return true;
}

bool PaneInput::gesture(QNativeGestureEvent* event) {
  const Vec2 at = toVec2(event->position());
  switch (event->gestureType()) {
    case Qt::ZoomNativeGesture:
      session_.pinch(pane_, at, 1 + event->value(), {}, 0);
      return true;
    case Qt::RotateNativeGesture:
      session_.pinch(pane_, at, 1, {}, event->value());
      return true;
    case Qt::PanNativeGesture:
      session_.pinch(pane_, at, 1, toVec2(event->delta()), 0);
      return true;
    default:
      return false;
  }
}

}  // namespace kiri::desktop
