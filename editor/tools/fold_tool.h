// The fold tool: grab paper and drag it over, or draw a line across (guide/interface.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/snap/constructions.h"
#include "editor/tools/drawn_line.h"
#include "editor/tools/fold_offer.h"
#include "editor/tools/open_flap.h"
#include "editor/tools/tool.h"

namespace kiri {

/// Pressed on paper and dragged, the paper follows the pointer and the crease appears half way; a
/// flap that is dragged back to where it came from opens its fold.
/// Pressed beside the paper and dragged, a line is drawn. Either stays until Enter or Escape, with
/// handles and fields. In the model pane and in the sheet pane alike.
class FoldTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override;
  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  std::vector<TintedFacet> tints(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  enum class Phase { Idle, Grabbing, Drawing, Resting };
  /// The paper in the hand.
  struct Grab {
    FacetName facet;
    Vec2 from;                  ///< where it was taken, paper frame of the facet
    std::optional<Line2> edge;  ///< the edge it was taken at
    Vec2 to;                    ///< where it is held now
  };

  Reaction press(const PointerEvent& event, const Scope& scope);
  Reaction move(const PointerEvent& event, const Scope& scope);
  Reaction release(const PointerEvent& event, const Scope& scope);
  void hover(const PointerEvent& event, const Scope& scope);
  void startAnew(const Scope& scope);
  bool takesPaper(const PointerEvent& event, const Scope& scope);
  void dragPaper(const PointerEvent& event, const Scope& scope);
  void modifyLayers(const Modifiers& modifiers);
  void lookAtLine(const Scope& scope, bool isNew);
  void rest(const Scope& scope);
  bool hasOffer() const { return offer_.isThere() || opening_; }
  void addOpening(const Scope& scope, Marks& marks) const;
  std::optional<Vec2> heldAt(const PaneMap& map, const FoldedState& state) const;
  std::optional<Vec2> edgeOntoEdge(const Scope& scope, Vec2 pixels, const Spot& onto) const;

  Phase phase_ = Phase::Idle;
  Pane pane_ = Pane::Model;
  std::optional<PointerEvent> pressed_;  ///< nothing has come of it yet
  std::optional<Grab> grab_;
  std::optional<FlapOpening> opening_;
  LayerMode modeBefore_ = LayerMode::Hand;
  bool isModeHeld_ = false;  ///< a modifier key says which layers
  LineHand line_;
  FoldOffer offer_;
  Marks caught_;
  CursorShape cursor_ = CursorShape::Arrow;
};

}  // namespace kiri
