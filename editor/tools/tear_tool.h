// Tearing along edges that are there (thesis 4.2).
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/tools/tear_path.h"
#include "editor/tools/tool.h"

namespace kiri {

/// A vertex is pressed and the pointer drawn along edges, or clicked from vertex to vertex; the
/// tear is the shortest way along edges through the vertices that the pointer came to. It may end
/// inside an edge. All layers whose edges lie there are torn; with Alt only the one that is seen.
class TearTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  /// With Ctrl: towards the person only this layer, away all of them.
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override { *this = TearTool(); }
  bool isBusy() const override { return phase_ != Phase::Idle; }

  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  /// "length" of the tear, mm; "layers".
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  enum class Phase { Idle, Dragging, Clicking, Resting };

  Reaction press(const PointerEvent& event, const Scope& scope);
  Reaction release(const PointerEvent& event, const Scope& scope);
  void follow(const PointerEvent& event, const Scope& scope);
  bool isOnEnd(const PointerEvent& event, const Scope& scope) const;
  std::optional<Vec2> startUnder(const PointerEvent& event, const Scope& scope) const;
  void markHinges(const FoldedState& state, Vec2 place, Marks& marks) const;

  Phase phase_ = Phase::Idle;
  Pane pane_ = Pane::Model;
  Vec2 pressedAt_;               ///< pixels
  std::optional<Vec2> hovered_;  ///< a vertex to start from, paper frame
  TearPath path_;
  bool isOneLayer_ = false;
  bool hasAlt_ = false;
};

}  // namespace kiri
