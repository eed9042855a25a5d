// Joining torn edges again (thesis 4.2).
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/tools/edge_walk.h"
#include "editor/tools/tool.h"

namespace kiri {

/// A click on a torn edge mends the tear that it is part of, as far as its sides lie together; with
/// Alt the edge alone.
class MendTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  /// With Ctrl: towards the person only this layer, away all of them.
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return isAll_ || isPressed_; }

  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  /// "reach" and "layers"; "all" is a button.
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  std::optional<EdgeId> hoveredIn(const FoldedState& state) const;
  TornRun meant(const FoldedState& state, EdgeId edge) const;

  std::optional<Vec2> hovered_;  ///< middle of a torn edge, paper frame
  bool isPressed_ = false;       ///< it is to be mended, wherever the pointer goes
  bool isAll_ = false;           ///< everything is to be mended
  bool isEdgeOnly_ = false;
  bool hasAlt_ = false;
  bool isOneLayer_ = false;
};

}  // namespace kiri
