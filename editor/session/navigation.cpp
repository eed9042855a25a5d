// From drags and wheels to cameras.
// SPDX-License-Identifier: MIT
#include "editor/session/navigation.h"

#include <cmath>

namespace kiri {

namespace {

constexpr double kZoomOfANotch = 1.2;

}  // namespace

bool Navigation::takesFirst(const PointerEvent& event) const {
  if (drag_) return true;
  if (event.action != PointerAction::Press) return false;
  return event.button == PointerButton::Middle || event.button == PointerButton::Right ||
         (event.button == PointerButton::Left && isSpaceHeld_);
}

bool Navigation::pointer(const PointerEvent& event) {
  switch (event.action) {
    case PointerAction::Press: {
      const bool shifts =
          event.pane == Pane::Sheet || isSpaceHeld_ || event.button == PointerButton::Middle;
      drag_ = Drag{event.pane, shifts ? Kind::Pan : Kind::Orbit, event.at};
      hasSpaceDragged_ = hasSpaceDragged_ || isSpaceHeld_;
      return true;
    }
    case PointerAction::Move:
      if (!drag_ || drag_->pane != event.pane) return false;
      move(event.at);
      return true;
    case PointerAction::Release: {
      const bool was = drag_.has_value();
      drag_.reset();
      return was;
    }
    case PointerAction::DoubleClick:
    case PointerAction::Leave:
      return false;
  }
  return false;
}

void Navigation::move(Vec2 to) {
  const Vec2 by = to - drag_->last;
  if (drag_->pane == Pane::Sheet) {
    sheet.pan(by);
  } else if (drag_->kind == Kind::Pan) {
    camera.pan(by);
  } else {
    camera.orbit(drag_->last, to);
  }
  drag_->last = to;
}

bool Navigation::wheel(const WheelEvent& event) {
  const double factor = std::pow(kZoomOfANotch, event.notches);
  if (event.pane == Pane::Sheet) {
    sheet.zoom(event.at, factor);
  } else {
    camera.zoom(event.at, factor);
  }
  return true;
}

void Navigation::pinch(Pane pane, Vec2 at, double factor, Vec2 pan, double rollDegrees) {
  if (pane == Pane::Sheet) {
    sheet.pan(pan);
    sheet.zoom(at, factor);
    return;
  }
  // Two fingers that move alike turn the model; that spread or twist, zoom and roll it.
  camera.orbit(at - pan, at);
  camera.zoom(at, factor);
  camera.turn(0, 0, rollDegrees);
}

void Navigation::setSpace(bool isHeld) {
  if (isHeld && !isSpaceHeld_) hasSpaceDragged_ = false;
  isSpaceHeld_ = isHeld;
}

void Navigation::resize(Pane pane, Vec2 pixels) {
  if (pane == Pane::Sheet) {
    sheet.resize(pixels);
  } else {
    camera.resize(pixels);
  }
}

}  // namespace kiri
