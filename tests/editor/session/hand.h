// A hand at a session: places in mm become pixels of the panes, as a person points at them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string_view>

#include "editor/session/session.h"
#include "tests/editor/session/journeys.h"
#include "tests/support/model_text.h"

namespace kiri::test {

/// A session of 800 x 600 (model) and 400 x 600 (sheet) pixels.
class Hand {
 public:
  explicit Hand(TaskRunner& runner) : session(runner, [this](const Changed& c) { note(c); }) {
    session.resize(Pane::Model, {800, 600});
    session.resize(Pane::Sheet, {400, 600});
  }

  void open(std::string_view text) { open(modelOf(text)); }
  void open(Model model) {
    Result<Document> document = Document::create(std::move(model));
    KIRI_CHECK(document.isOk(), "the test's model has a sheet");
    session.open(std::move(*document));
  }

  /// Where a place of the model frame (z = 0), or of the sheet, is seen.
  Vec2 pixels(Vec2 mm) const { return map().toPixels(Vec3{mm.x, mm.y, 0}); }
  PaneMap map() const {
    Session& open = const_cast<Session&>(session);
    return pane == Pane::Model ? open.camera().map() : open.sheetCamera().map();
  }

  void send(PointerAction action, Vec2 at, PointerButton button) {
    session.pointer({action, pane, at, button, held, false});
  }
  void press(Vec2 mm, PointerButton button = PointerButton::Left) {
    send(PointerAction::Press, pixels(mm), button);
  }
  void moveTo(Vec2 mm, PointerButton button = PointerButton::Left) {
    send(PointerAction::Move, pixels(mm), button);
  }
  void release(Vec2 mm, PointerButton button = PointerButton::Left) {
    send(PointerAction::Release, pixels(mm), button);
  }
  void drag(Vec2 from, Vec2 to, bool isFree = false, PointerButton button = PointerButton::Left) {
    const Modifiers before = held;
    moveTo(from, PointerButton::None);
    press(from, button);
    held.control = held.control || isFree;
    for (const double part : {0.25, 0.5, 0.75, 1.0}) moveTo(lerp(from, to, part), button);
    release(to, button);
    held = before;
  }
  void click(Vec2 mm) {
    moveTo(mm, PointerButton::None);
    press(mm);
    release(mm);
  }
  bool key(Key key) { return session.key({key, 0, held, true}); }
  bool key(char character) { return session.key({Key::Character, character, held, true}); }
  void set(const char* field, double value) { session.setField(field, {value, {}}); }

  std::size_t stepCount() const { return session.document().count(); }
  std::size_t tinted(FacetTint tint) const {
    const Shown shown = session.shown();
    return static_cast<std::size_t>(std::count(shown.tints.begin(), shown.tints.end(), tint));
  }

  Pane pane = Pane::Model;
  Modifiers held;
  int told = 0;  ///< how often the listener was called
  Changed last;  ///< and with what
  Session session;

 private:
  void note(const Changed& changed) {
    ++told;
    last = changed;
  }
};

/// A person at a session without a window.
class Sitter final : public Person {
 public:
  explicit Sitter(Hand& hand) : hand_(hand) {}

  Session& session() override { return hand_.session; }
  void take(ToolId tool) override { hand_.session.setTool(tool); }
  void drag(Pane pane, Vec2 from, Vec2 to, bool isFree) override {
    hand_.pane = pane;
    hand_.drag(from, to, isFree);
  }
  void click(Pane pane, Vec2 at) override {
    hand_.pane = pane;
    hand_.click(at);
  }
  void press(Key key) override { hand_.key(key); }
  void press(char key) override { hand_.key(key); }
  void set(const std::string& field, double value) override { hand_.set(field.c_str(), value); }
  void command(const std::string& name) override {
    Step step;
    if (name == "undo") return hand_.session.undo();
    if (name == "redo") return hand_.session.redo();
    const Sequence sequence = hand_.session.document().model().opening;
    if (name == "unfold-all") step.action = UnfoldStep{{}, sequence};
    if (name == "refold-all") step.action = RefoldStep{{}, sequence};
    hand_.session.change(addStep(step), {});
  }
  void wait() override {}
  void holdControl(bool isHeld) override { hand_.held.control = isHeld; }

 private:
  Hand& hand_;
};

}  // namespace kiri::test
