// One slider for each fold line (thesis 4.5, G), and one for all of them (B17).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

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

/// How far all of it is open: 0 as it was folded, 1 unfolded, by the degrees of all fold lines.
/// Lines whose hinges disagree count as folded.
double opennessOf(const FoldedState& state);

/// Sliders whose names differ in a number at the end only: "vein 1" and "vein 2" are of "vein".
struct SliderGroup {
  std::string name;               ///< what the names have in common; of one slider: its name
  std::vector<std::size_t> rows;  ///< places in the list of sliders
};

/// Each slider is in one group; groups stand where their first slider does.
std::vector<SliderGroup> groupsOf(const std::vector<FoldSlider>& sliders);

/// What a dragged slider shows. The way is from the state at which the drag began, so that dragging
/// back undoes exactly.
struct SlideShow {
  std::shared_ptr<const FoldedState> state;
  double amount = 0;                  ///< where the paper stopped
  std::optional<Error> stop;          ///< why it went no further
  std::vector<Collision> collisions;  ///< met on the way; they do not stop it
};
/// `amount` in degrees of the fold's own direction; beyond -180 and 180 it is cut off. Lines that
/// are held in closed loops of creases take others with them, and more time.
SlideShow slideTo(const FoldedState& from, FoldLineId line, double amount);

/// The step that a released slider makes; none when nothing changed.
std::optional<Step> stepOfSlide(const FoldedState& from, FoldLineId line, double amount);

}  // namespace kiri
