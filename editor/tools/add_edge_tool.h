// Adding an edge that nothing folds, for tearing along it (thesis 4.3).
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/tools/cut_layers.h"
#include "editor/tools/drawn_line.h"

namespace kiri {

class AddEdgeTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return hand_.isBusy(); }

  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  /// Those of the line and the layers; "project" puts both ends onto the edges nearest to them.
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  bool isResting() const { return hand_.isThere() && !hand_.isMoving(); }
  std::optional<PlaneTrace> trace(const Scope& scope) const;
  void project(const Scope& scope);
  /// What the edge will be longer than it was drawn: in each layer it runs from edge to edge.
  std::vector<FacetLine> beyondDrawn(const Scope& scope) const;

  LineHand hand_;
  CutLayers layers_{false};
};

}  // namespace kiri
