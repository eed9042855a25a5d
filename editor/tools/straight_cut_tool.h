// Cutting along a straight line (thesis 4.4).
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/tools/cut_hand.h"
#include "editor/tools/drawn_line.h"

namespace kiri {

/// The line is drawn by a drag or two clicks, then what stays is chosen.
class StraightCutTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return hand_.isBusy(); }

  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  bool isResting() const { return hand_.isThere() && !hand_.isMoving(); }
  std::optional<CutHand::Line> line(const Scope& scope) const;
  void looksAtParts(const Scope& scope);
  Reaction press(const PointerEvent& event, const Scope& scope);

  LineHand hand_;
  CutHand cut_;
  std::optional<PointerEvent> press_;  ///< on the paper, before it is known to be a click
};

}  // namespace kiri
