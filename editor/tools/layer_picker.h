// Choosing layers in place: the stack under the pointer, fanned out (thesis Fig 4.3).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/step.h"
#include "editor/tools/scope.h"

namespace kiri {

/// Which layers a line or cut works on.
enum class LayerMode {
  Hand,  ///< what a hand would take: the flap under the pointer and what is joined to it across
         ///< the line
  Top,   ///< the uppermost layer
  All,
  Chosen,  ///< those picked one by one
};

/// The layers of one plane under a line, the uppermost to the eye first, and which are taken.
class LayerPicker {
 public:
  /// Looks at the layers that the line (in the plane of its facet) crosses; keeps what was chosen
  /// where it is still there. `grabbed`: the paper that the hand holds.
  void look(const Scope& scope, const DrawnLine& line, std::optional<Spot> grabbed);
  void reset();

  LayerMode mode() const { return mode_; }
  void setMode(LayerMode mode);
  /// The wheel: takes one layer more (positive) or fewer, from the top as the eye sees it.
  void walk(int layers);
  void toggle(FacetId facet);

  const std::vector<FacetId>& stack() const { return stack_; }
  const std::vector<FacetId>& taken() const { return taken_; }
  /// For a step: places on the paper.
  LayerChoice choice(const FoldedState& state) const;

 private:
  LayerMode mode_ = LayerMode::Hand;
  int count_ = 1;
  std::vector<FacetId> stack_;
  std::vector<FacetId> taken_;
  std::vector<Vec2> chosen_;  ///< paper frame
};

}  // namespace kiri
