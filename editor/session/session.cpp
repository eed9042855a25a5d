// The session's document, tools and pictures.
// SPDX-License-Identifier: MIT
#include "editor/session/session.h"

#include <utility>

#include "editor/session/fault_marks.h"
#include "editor/session/session_parts.h"

namespace kiri {

Session::Session(TaskRunner& runner, std::function<void(const Changed&)> listener)
    : parts_(std::make_unique<Parts>(runner, std::move(listener))) {
  fitAll();
}

Session::~Session() = default;

const Document& Session::document() const { return parts_->document; }

void Session::open(Document document, PatternReport report) {
  parts_->queue.cancel();
  parts_->dropGesture();
  parts_->committing.reset();
  parts_->selection.clear();
  parts_->document = std::move(document);
  parts_->pattern.setReport(std::move(report));
  parts_->say(Notice::Kind::None, {});
  parts_->changed.selection = true;
  parts_->documentChanged();
  parts_->navigation.camera.look(Camera::Preset::Front, sphereOf(*parts_->document.state()));
  fitAll();
}

void Session::change(Change change, const Phrase& what) {
  parts_->ask(std::move(change), what, false);
  parts_->tell();
}

void Session::undo() {
  if (parts_->tool().isBusy()) {
    parts_->dropGesture();
    parts_->refreshProposal();
  } else {
    parts_->queue.add([this] {
      if (parts_->document.undo()) parts_->documentChanged();
    });
  }
  parts_->say(Notice::Kind::None, {});
  parts_->tell();
}

void Session::redo() {
  parts_->queue.add([this] {
    if (parts_->document.redo()) parts_->documentChanged();
  });
  parts_->say(Notice::Kind::None, {});
  parts_->tell();
}

void Session::jumpTo(std::size_t steps) {
  parts_->dropGesture();
  parts_->queue.add([this, steps] {
    if (parts_->document.jumpTo(steps)) parts_->documentChanged();
  });
  parts_->tell();
}

void Session::noteSaved(const std::string& path) {
  parts_->document.setPath(path);
  parts_->document.noteSaved();
  parts_->changed.document = true;
  parts_->tell();
}

bool Session::isBusy() const { return parts_->queue.isBusy(); }

void Session::cancelWork() {
  parts_->queue.cancel();
  parts_->playerTask.clear();
  parts_->changed.busy = true;
  parts_->tell();
}

ToolId Session::tool() const { return parts_->toolId; }

void Session::setTool(ToolId tool) {
  if (tool == parts_->toolId && !parts_->isPlayerOpen) return;
  parts_->dropGesture();
  parts_->isPlayerOpen = false;
  parts_->toolId = tool;
  parts_->say(Notice::Kind::None, {});
  parts_->changed.tool = true;
  parts_->refreshProposal();
  parts_->tell();
}

std::vector<Field> Session::fields() const {
  return parts_->isPlayerOpen ? std::vector<Field>{} : parts_->tool().fields(parts_->scope());
}

void Session::setField(const std::string& id, const FieldValue& value) {
  parts_->react(parts_->tool().setField(id, value, parts_->scope()));
  parts_->tell();
}

bool Session::canCommit() const {
  const std::optional<Proposal> proposal = parts_->proposal();
  return proposal && proposal->isComplete;
}

void Session::commit() {
  parts_->react({.isHandled = true, .wantsCommit = true});
  parts_->tell();
}

void Session::cancel() {
  if (parts_->slides.isSliding()) return endSlide(false);
  if (parts_->isPlayerOpen) return closePlayer();
  if (parts_->tool().isBusy()) {
    parts_->dropGesture();
  } else {
    parts_->selection.clear();
    parts_->changed.selection = true;
  }
  parts_->say(Notice::Kind::None, {});
  parts_->refreshProposal();
  parts_->tell();
}

SnapSettings& Session::snaps() { return parts_->snaps; }
Phrase Session::hint() const { return parts_->tool().hint(parts_->scope()); }
const Selection& Session::selection() const { return parts_->selection; }
const Notice& Session::notice() const { return parts_->notice; }
const Facts& Session::facts() const { return parts_->facts; }
Shown Session::shown() const { return parts_->shown; }

CursorShape Session::cursor() const {
  if (parts_->navigation.isDragging()) return CursorShape::Orbit;
  if (parts_->navigation.hasSpace()) return CursorShape::Hand;
  if (parts_->isPlayerOpen) return CursorShape::Orbit;
  return parts_->tool().cursor(parts_->scope());
}

void Session::setSelection(Selection selection) {
  parts_->selection = std::move(selection);
  parts_->changed.selection = true;
  parts_->refreshProposal();
  parts_->tell();
}

Marks Session::marks() const {
  if (parts_->isPlayerOpen) return {};
  const FoldedState& state = *parts_->document.state();
  Marks marks = parts_->tool().marks(parts_->scope());
  const auto add = [&marks](const Marks& more) {
    marks.insert(marks.end(), more.begin(), more.end());
  };
  if (const Preview* preview = parts_->previewer.current()) {
    if (preview->error) add(marksOf(preview->error->witness, state));
    add(marksOf(preview->collisions, state));
  }
  if (parts_->slides.isSliding() && parts_->slides.show()) {
    const SlideShow& show = *parts_->slides.show();
    if (show.stop) add(marksOf(show.stop->witness, state));
    add(marksOf(show.collisions, state));
  }
  add(marksOf(parts_->witness, state));
  add(parts_->pattern.marks(parts_->navigation.sheet.map()));
  add(parts_->guide);
  return marks;
}

PatternDesk& Session::pattern() { return parts_->pattern; }

void Session::lookAt(const PatternEntry& entry) {
  parts_->pattern.point(entry);
  const std::vector<Vec2> places = parts_->pattern.places(entry);
  if (places.empty()) return;
  Box box{places.front(), places.front()};
  for (const Vec2 place : places) box = joined(box, Box{place, place});
  SheetCamera& sheet = parts_->navigation.sheet;
  const PaneMap map = sheet.map();
  const Vec2 middle = (box.low + box.high) / 2;
  sheet.pan(map.size / 2 - map.toPixels(Vec3{middle.x, middle.y, 0}));
  viewChanged();
}

void Session::setGuide(Marks guide) {
  parts_->guide = std::move(guide);
  parts_->changed.marks = true;
  parts_->tell();
}

}  // namespace kiri
