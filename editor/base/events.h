// What the hand does, free of any toolkit.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/vec.h"

namespace kiri {

/// The two pictures of one thing: the folded model, and the flat sheet.
enum class Pane { Model, Sheet };

enum class PointerAction { Press, Move, Release, DoubleClick, Leave };
enum class PointerButton { None, Left, Middle, Right };

struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;
};

/// Pixels are those of the toolkit (device independent), y down from the upper left of the pane.
struct PointerEvent {
  PointerAction action = PointerAction::Move;
  Pane pane = Pane::Model;
  Vec2 at;
  PointerButton button = PointerButton::None;  ///< pressed or released; Move: held down, if any
  Modifiers modifiers;
  bool isTouch = false;
};

struct WheelEvent {
  Pane pane = Pane::Model;
  Vec2 at;
  double notches = 0;  ///< positive: away from the person
  Modifiers modifiers;
};

enum class Key {
  Escape,
  Enter,
  Delete,
  Backspace,
  Insert,
  Tab,
  Left,
  Right,
  Up,
  Down,
  Space,
  Character,
};

struct KeyEvent {
  Key key = Key::Character;
  char character = 0;  ///< Character: lower-case letter, digit or sign, ASCII
  Modifiers modifiers;
  bool isPress = true;
};

/// How the pointer should look.
enum class CursorShape { Arrow, Cross, Hand, ClosedHand, Scissors, Tear, Pen, Forbidden, Orbit };

}  // namespace kiri
