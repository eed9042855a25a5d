// One slider for each fold line (thesis 4.5, G).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"
#include "editor/base/field.h"
#include "editor/base/phrase.h"

namespace kiri {

/// A row of the folds panel.
struct FoldSlider {
  FoldLineId line;
  std::string name;
  bool isValley = true;
  std::optional<double> amount;  ///< degrees in the fold's own direction; none: hinges disagree
  bool canMove = true;           ///< false: the line has no hinges left
};

/// The sliders of a state, in the order of folding.
std::vector<FoldSlider> slidersOf(const FoldedState& state);

/// What a dragged slider shows. The way is from the state at which the drag began, so that dragging
/// back undoes exactly.
struct SlideShow {
  std::shared_ptr<const FoldedState> state;
  double amount = 0;          ///< where the paper stopped
  std::optional<Error> stop;  ///< why it went no further
  std::vector<Collision> collisions;
};
SlideShow slideTo(const FoldedState& from, FoldLineId line, double amount);

/// The one slider for all: 0 is unfolded, 1 as folded. Together as leaves do, or in order (thesis
/// B17). Prepared once for a drag, then asked for moments.
class AllSlider {
 public:
  /// Errors: those of unfolding all of it. Cancelled.
  static Result<AllSlider> prepare(const FoldedState& state, Sequence sequence,
                                   const Progress& progress = {});
  FoldedState at(double openness) const;  ///< 0: as it is folded now, 1: all unfolded

 private:
  AllSlider() = default;
  struct Ways;
  std::shared_ptr<const Ways> ways_;
};

/// The step that a released slider makes; none when nothing changed.
std::optional<Step> stepOfSlide(const FoldedState& from, FoldLineId line, double amount);

}  // namespace kiri
