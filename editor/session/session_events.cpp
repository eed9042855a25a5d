// What the hand does in the panes.
// SPDX-License-Identifier: MIT
#include "core/paper/boxes.h"
#include "editor/session/session_parts.h"

namespace kiri {

void Session::resize(Pane pane, Vec2 pixels) {
  parts_->navigation.resize(pane, pixels);
  viewChanged();
}

Camera& Session::camera() { return parts_->navigation.camera; }
SheetCamera& Session::sheetCamera() { return parts_->navigation.sheet; }

void Session::viewChanged() {
  parts_->changed.view = true;
  parts_->changed.marks = true;
  parts_->tell();
}

void Session::fitAll() {
  parts_->navigation.camera.fit(sphereOf(*parts_->shown.state));
  parts_->navigation.sheet.fit(paperBoxOf(parts_->document.state()->pattern));
  viewChanged();
}

void Session::pointer(const PointerEvent& event) {
  Parts& parts = *parts_;
  parts.areSnapsSuspended = event.modifiers.control;
  if (event.action == PointerAction::Press) {
    parts.say(Notice::Kind::None, {});
  }
  if (parts.navigation.takesFirst(event) || parts.isPlayerOpen) {
    if (parts.navigation.pointer(event)) return viewChanged();
    return;
  }
  const Reaction reaction = parts.tool().pointer(event, parts.scope());
  if (!reaction.isHandled && event.action == PointerAction::Press &&
      event.button == PointerButton::Left) {
    parts.navigation.pointer(event);
    parts.changed.view = true;
  }
  parts.react(reaction);
  parts.tell();
}

void Session::wheel(const WheelEvent& event) {
  Parts& parts = *parts_;
  if (!parts.isPlayerOpen) {
    const Reaction reaction = parts.tool().wheel(event, parts.scope());
    if (reaction.isHandled) {
      parts.react(reaction);
      return parts.tell();
    }
  }
  parts.navigation.wheel(event);
  viewChanged();
}

void Session::pinch(Pane pane, Vec2 at, double factor, Vec2 pan, double rollDegrees) {
  // The first of two fingers may have begun to draw.
  if (parts_->tool().isBusy()) parts_->dropGesture();
  parts_->navigation.pinch(pane, at, factor, pan, rollDegrees);
  parts_->refreshProposal();
  viewChanged();
}

bool Session::key(const KeyEvent& event) {
  Parts& parts = *parts_;
  if (event.key == Key::Space && !event.isPress) {
    const bool isTap = parts.navigation.hasSpace() && !parts.navigation.hasSpaceDragged();
    parts.navigation.setSpace(false);
    if (isTap) {
      if (!parts.isPlayerOpen) {
        openPlayer();
      } else if (parts.player.isPlaying()) {
        parts.player.pause();
      } else {
        parts.player.play();
      }
    }
    viewChanged();
    return true;
  }
  if (!event.isPress) return false;
  if (!parts.isPlayerOpen) {
    const Reaction reaction = parts.tool().key(event, parts.scope());
    if (reaction.isHandled) {
      parts.react(reaction);
      parts.tell();
      return true;
    }
  }
  switch (event.key) {
    case Key::Space:
      parts.navigation.setSpace(true);
      viewChanged();
      return true;
    case Key::Escape:
      cancel();
      return true;
    case Key::Enter:
      if (!canCommit()) return false;
      commit();
      return true;
    default:
      return false;
  }
}

}  // namespace kiri
