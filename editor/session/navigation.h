// Turning, shifting and zooming the panes by hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "editor/base/events.h"
#include "editor/view/camera.h"

namespace kiri {

/// Middle drag or a held space key shifts; right drag turns the model and shifts the sheet; so does
/// a left drag that no tool wants. The wheel zooms about the pointer.
class Navigation {
 public:
  Camera camera;
  SheetCamera sheet;

  /// True when the event is the navigation's before any tool is asked: the drag is under way, or
  /// begins with a button that no tool uses.
  bool takesFirst(const PointerEvent& event) const;
  /// True when a camera has moved or a drag has begun.
  bool pointer(const PointerEvent& event);
  bool wheel(const WheelEvent& event);
  void pinch(Pane pane, Vec2 at, double factor, Vec2 pan, double rollDegrees);
  /// The space key is held: every drag shifts.
  void setSpace(bool isHeld);
  bool hasSpace() const { return isSpaceHeld_; }
  /// The space key was held for a drag, so letting it go is no tap.
  bool hasSpaceDragged() const { return hasSpaceDragged_; }
  bool isDragging() const { return drag_.has_value(); }
  void resize(Pane pane, Vec2 pixels);

 private:
  enum class Kind { Orbit, Pan };
  struct Drag {
    Pane pane;
    Kind kind;
    Vec2 last;
  };
  void move(Vec2 to);

  std::optional<Drag> drag_;
  bool isSpaceHeld_ = false;
  bool hasSpaceDragged_ = false;
};

}  // namespace kiri
