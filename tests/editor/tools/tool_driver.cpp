// SPDX-License-Identifier: MIT
#include "tests/editor/tools/tool_driver.h"

#include <stdexcept>
#include <utility>

#include "core/model/apply.h"
#include "core/paper/boxes.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

constexpr int kMoves = 6;

Sphere ballOf(const FoldedState& state) {
  const ModelBox box = modelBoxOf(state);
  return {box.middle(), distance(box.low, box.high) / 2};
}

}  // namespace

ToolDriver::ToolDriver(ToolId tool, std::string_view text) : ToolDriver(tool, run(text)) {}

ToolDriver::ToolDriver(ToolId tool, FoldedState state)
    : tool_(makeTool(tool)), state_(std::make_shared<const FoldedState>(std::move(state))) {
  camera.resize({800, 600});
  sheetCamera.resize({400, 600});
  look(Camera::Preset::Front);
  sheetCamera.fit(paperBoxOf(state_->pattern));
}

void ToolDriver::look(Camera::Preset preset) {
  camera.look(preset, ballOf(*state_));
  camera.fit(ballOf(*state_));
}

Scope ToolDriver::scope() const {
  return {state_,
          static_cast<int>(steps_.size() + state_->lines.size()) + 1,
          camera.map(),
          sheetCamera.map(),
          snaps,
          selection,
          hasPreview_ ? &preview_ : nullptr,
          false};
}

Vec2 ToolDriver::pixels(Vec2 mm) const {
  const Vec3 p{mm.x, mm.y, pane == Pane::Model ? height : 0};
  return scope().map(pane).toPixels(p);
}

PointerEvent ToolDriver::event(PointerAction action, Vec2 mm, PointerButton button) const {
  return {action, pane, pixels(mm), button, held, false};
}

Reaction ToolDriver::took(const Reaction& reaction) {
  if (reaction.selection) selection = *reaction.selection;
  if (reaction.wantsCommit) {
    commit();
    return reaction;
  }
  hasPreview_ = false;
  if (const auto offered = proposal()) {
    const auto after = apply(*state_, offered->step, scope().number);
    preview_ = {offered->step, state_, nullptr, std::nullopt, {}};
    if (after) {
      preview_.after = std::make_shared<const FoldedState>(*after);
      const auto added = static_cast<std::ptrdiff_t>(state_->collisions.size());
      preview_.collisions.assign(after->collisions.begin() + added, after->collisions.end());
    } else {
      preview_.error = after.error();
    }
    hasPreview_ = true;
  }
  return reaction;
}

Reaction ToolDriver::send(const PointerEvent& event) {
  return took(tool_->pointer(event, scope()));
}
Reaction ToolDriver::send(const KeyEvent& event) { return took(tool_->key(event, scope())); }
Reaction ToolDriver::send(const WheelEvent& event) { return took(tool_->wheel(event, scope())); }

Reaction ToolDriver::press(Vec2 mm) {
  isDown_ = true;
  return send(event(PointerAction::Press, mm, PointerButton::Left));
}

Reaction ToolDriver::moveTo(Vec2 mm) {
  return send(event(PointerAction::Move, mm, isDown_ ? PointerButton::Left : PointerButton::None));
}

Reaction ToolDriver::release(Vec2 mm) {
  isDown_ = false;
  return send(event(PointerAction::Release, mm, PointerButton::Left));
}

void ToolDriver::hover(Vec2 mm) { moveTo(mm); }

void ToolDriver::drag(Vec2 from, Vec2 to) {
  hover(from);
  press(from);
  for (int i = 1; i <= kMoves; ++i) moveTo(lerp(from, to, static_cast<double>(i) / kMoves));
  release(to);
}

Reaction ToolDriver::click(Vec2 mm) {
  hover(mm);
  press(mm);
  return release(mm);
}

Reaction ToolDriver::doubleClick(Vec2 mm) {
  return send(event(PointerAction::DoubleClick, mm, PointerButton::Left));
}

Reaction ToolDriver::key(Key key) { return send(KeyEvent{key, 0, held, true}); }
Reaction ToolDriver::key(char character) {
  return send(KeyEvent{Key::Character, character, held, true});
}

Reaction ToolDriver::wheel(Vec2 mm, double notches) {
  return send(WheelEvent{pane, pixels(mm), notches, held});
}

Reaction ToolDriver::set(const std::string& field, double value) {
  return took(tool_->setField(field, {value, {}}, scope()));
}
Reaction ToolDriver::set(const std::string& field, const std::string& text) {
  return took(tool_->setField(field, {0, text}, scope()));
}

Step ToolDriver::step() const {
  const auto offered = proposal();
  if (!offered) throw std::runtime_error("the tool proposes nothing");
  return offered->step;
}

Result<FoldedState> ToolDriver::result() const { return apply(*state_, step(), scope().number); }

double ToolDriver::areaAfter() const {
  const Result<FoldedState> after = result();
  return after ? areaOf(*after) : -1;
}

Field ToolDriver::field(const std::string& id) const {
  for (const Field& field : tool_->fields(scope())) {
    if (field.id == id) return field;
  }
  throw std::runtime_error("the tool shows no field \"" + id + "\"");
}

bool ToolDriver::hasField(const std::string& id) const {
  for (const Field& field : tool_->fields(scope())) {
    if (field.id == id) return true;
  }
  return false;
}

std::size_t ToolDriver::count(MarkRole role) const {
  std::size_t found = 0;
  for (const Mark& mark : tool_->marks(scope())) {
    if (const auto* path = std::get_if<PathMark>(&mark)) found += path->role == role;
    if (const auto* point = std::get_if<PointMark>(&mark)) found += point->role == role;
    if (const auto* text = std::get_if<TextMark>(&mark)) found += text->role == role;
  }
  return found;
}

bool ToolDriver::commit() {
  const auto offered = proposal();
  if (!offered || !offered->isComplete) return false;
  auto after = apply(*state_, offered->step, scope().number);
  if (!after) return false;
  state_ = std::make_shared<const FoldedState>(std::move(*after));
  steps_.push_back(offered->step);
  hasPreview_ = false;
  tool_->reset();
  return true;
}

}  // namespace kiri::test
