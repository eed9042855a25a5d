// The stack of layers under a line, fanned out beside it to be clicked (guide/interface.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "editor/tools/layer_picker.h"

namespace kiri {

/// One card for each layer that lies under the middle of the line, the uppermost first. Cards stand
/// in a row beside that place, in pixels of the pane, so that hidden layers can be picked too.
class LayerFan {
 public:
  bool isOpen() const { return isOpen_; }
  void setOpen(bool isOpen) { isOpen_ = isOpen; }
  /// Which card the pointer is over; shown in its place on the paper.
  void hover(const PointerEvent& event, const Scope& scope, const FacetLine& line, Pane pane);
  /// The layer whose card is under the pointer, while it is open.
  std::optional<FacetId> cardUnder(const PointerEvent& event, const Scope& scope,
                                   const FacetLine& line, Pane pane) const;
  void addMarks(const Scope& scope, const FacetLine& line, Pane pane,
                const std::vector<FacetId>& taken, Marks& marks) const;

 private:
  struct Card {
    FacetId facet;
    Vec2 at;  ///< its middle, pixels
  };
  std::vector<Card> cards(const Scope& scope, const FacetLine& line, Pane pane) const;

  bool isOpen_ = false;
  std::optional<FacetId> hovered_;
};

}  // namespace kiri
