// The angle tool: opens and closes creases that are there by a dial.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/tools/tool.h"

namespace kiri {

/// A crease under the pointer lights up; pressed and dragged, its fold line opens or closes, with a
/// dial. The step names the fold line. Without a drag the angle can be typed after a click.
class AngleTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return chosen_.has_value(); }
  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  /// A fold line that is being set, and the hinge of it that the hand took.
  struct Chosen {
    std::string line;
    Vec2 place;     ///< on the hinge, paper frame
    double before;  ///< degrees in the fold's own direction, as it is now
    double amount;  ///< as it is to be
    bool isHeld = true;
    Pane pane = Pane::Model;
    Vec2 pressedAt = {};  ///< pixels
    double pressedAmount = 0;
  };

  std::optional<EdgeId> creaseUnder(const PointerEvent& event, const Scope& scope) const;
  bool choose(const Scope& scope, const std::string& line, Vec2 place);
  void turn(const PointerEvent& event, const Scope& scope);
  void addDial(const Scope& scope, Marks& marks) const;

  std::optional<Chosen> chosen_;
  std::string hovered_;  ///< a fold line
};

}  // namespace kiri
