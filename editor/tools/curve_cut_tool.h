// Cutting along a B-spline that stays editable until it is made (thesis 4.4).
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/tools/curve_hand.h"
#include "editor/tools/cut_hand.h"

namespace kiri {

/// First the curve is drawn, then its parts are looked at and what stays is chosen.
class CurveCutTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return curve_.isBusy(); }

  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  std::optional<CutHand::Line> line(const Scope& scope) const;
  void looksAtParts(const Scope& scope);

  CurveHand curve_;
  CutHand cut_;
};

}  // namespace kiri
