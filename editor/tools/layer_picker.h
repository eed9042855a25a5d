// Choosing layers in place: the stack under the pointer, fanned out (thesis Fig 4.3).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/model/step.h"
#include "editor/tools/parted_paper.h"
#include "editor/tools/scope.h"

namespace kiri {

/// Which layers a line or cut works on.
enum class LayerMode {
  Hand,  ///< what a hand would take: the flap under the pointer and what is joined to it across
         ///< the line
  Top,   ///< the uppermost layers, one unless walked on
  All,
  Chosen,  ///< those picked one by one
};

/// What a fold needs to know beyond its line.
struct FoldHand {
  const PartedPaper& paper;  ///< parted along the line
  bool leftMoves = true;     ///< as in FoldRequest
  bool isEndless = false;    ///< the line has no ends: it goes as far as the paper that is taken
};

/// The layers of one plane under a line, the uppermost to the eye first, and which are taken.
class LayerPicker {
 public:
  /// Looks at the layers that the line (in the plane of its facet) crosses; keeps what was chosen
  /// where it is still there. `grabbed`: the paper that the hand holds. `pane`: whose eye says what
  /// is uppermost. For lines that do not fold, a hand takes the uppermost paper only.
  void look(const Scope& scope, const DrawnLine& line, std::optional<Spot> grabbed,
            Pane pane = Pane::Model);
  /// The same for folds: a hand takes with the flap what must come along.
  void look(const Scope& scope, const FacetLine& line, std::optional<Spot> grabbed, Pane pane,
            const FoldHand& hand);
  void reset();

  LayerMode mode() const { return mode_; }
  void setMode(LayerMode mode);
  /// How many layers LayerMode::Top takes.
  int count() const { return count_; }
  void setCount(int count);
  /// The wheel: takes one layer more (positive) or fewer, from the top as the eye sees it.
  void walk(int layers);
  /// Takes the facet, or leaves it; the others as they are now.
  void toggle(const FoldedState& state, FacetId facet);
  /// Takes these and no others.
  void choose(const FoldedState& state, const std::vector<FacetId>& facets);

  const std::vector<FacetId>& stack() const { return stack_; }
  const std::vector<FacetId>& taken() const { return taken_; }
  /// The part of the line that reaches all that is taken, in units of the line; after a fold's
  /// look.
  Stretch stretch() const { return stretch_; }
  /// For a step: places on the paper.
  LayerChoice choice(const FoldedState& state) const;

 private:
  void lookAtStack(const FoldedState& state, const FacetLine& line, Stretch within, Vec3 up);
  std::vector<FacetId> topmostAlong(const FoldedState& state, const FacetLine& line, Stretch within,
                                    Vec3 up, int count) const;
  std::vector<FacetId> crossedAmong(const FoldedState& state, const FacetLine& line, Stretch within,
                                    Vec3 up, std::optional<Spot> grabbed) const;
  std::vector<FacetId> chosenOnes(const FoldedState& state, const FacetLine& line) const;
  void reachChosen(const FoldedState& state, const FacetLine& line);

  LayerMode mode_ = LayerMode::Hand;
  int count_ = 1;
  std::vector<FacetId> stack_;
  std::vector<FacetId> taken_;
  std::vector<Vec2> chosen_;  ///< paper frame
  Stretch stretch_{0, 1};
};

}  // namespace kiri
