// Drives a tool by events alone, as a session does: previews after each, commits when it asks.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/tools/tool.h"
#include "editor/view/camera.h"

namespace kiri::test {

/// A tool, a state, and the eyes of both panes. Places are mm: in the model pane x and y of the
/// model frame in the plane z = `height`, in the sheet pane those of the paper.
class ToolDriver {
 public:
  /// `text`: a model as in model_text.h; the tool works on what its steps lead to.
  ToolDriver(ToolId tool, std::string_view text);
  ToolDriver(ToolId tool, FoldedState state);

  // What the hand does.
  Reaction press(Vec2 mm);
  Reaction moveTo(Vec2 mm);
  Reaction release(Vec2 mm);
  void hover(Vec2 mm);
  /// Press, a few moves, release.
  void drag(Vec2 from, Vec2 to);
  Reaction click(Vec2 mm);
  Reaction doubleClick(Vec2 mm);
  Reaction key(Key key);
  Reaction key(char character);
  Reaction wheel(Vec2 mm, double notches);
  Reaction set(const std::string& field, double value);
  Reaction set(const std::string& field, const std::string& text);
  Reaction push(const std::string& button) { return set(button, 0.0); }
  Reaction send(const PointerEvent& event);
  Reaction send(const KeyEvent& event);
  Reaction send(const WheelEvent& event);

  // What is set up.
  Pane pane = Pane::Model;  ///< where the hand is
  double height = 0;
  Modifiers held;
  SnapSettings snaps;
  Camera camera;
  SheetCamera sheetCamera;
  Selection selection;
  void look(Camera::Preset preset);

  // What comes of it.
  Vec2 pixels(Vec2 mm) const;
  Tool& tool() { return *tool_; }
  Scope scope() const;
  const FoldedState& state() const { return *state_; }
  std::optional<Proposal> proposal() const { return tool_->proposal(scope()); }
  /// The step of the proposal. Throws when there is none.
  Step step() const;
  /// The proposal's step applied by itself. Throws when there is none.
  Result<FoldedState> result() const;
  /// The area, mm2, of what would come of it; -1 when it does not apply.
  double areaAfter() const;
  /// The field. Throws when the tool shows none of this name.
  Field field(const std::string& id) const;
  bool hasField(const std::string& id) const;
  /// Marks of one role.
  std::size_t count(MarkRole role) const;
  /// Applies the proposal, as Enter does; the tool goes on with what came of it. False: there was
  /// none, or it does not apply; then nothing changes.
  bool commit();
  /// What was committed, from the first.
  const std::vector<Step>& steps() const { return steps_; }

 private:
  PointerEvent event(PointerAction action, Vec2 mm, PointerButton button) const;
  Reaction took(const Reaction& reaction);

  std::unique_ptr<Tool> tool_;
  std::shared_ptr<const FoldedState> state_;
  std::vector<Step> steps_;
  Preview preview_;
  bool hasPreview_ = false;
  bool isDown_ = false;
};

}  // namespace kiri::test
