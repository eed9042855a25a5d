// A crease pattern as a model: the sheet is its outline, its creases are the first step.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"
#include "core/model/model.h"
#include "core/model/pattern_motion.h"
#include "core/paper/folded_state.h"

namespace kiri {

struct PatternModelOptions {
  std::string title;
  /// mm of the longest side of the sheet's box; 0: coordinates are taken as mm, to the last bit.
  double longestSide = 0;
  /// Fold it as far as its target angles say; where that cannot be, notes say why and the model is
  /// the flat creased sheet.
  bool isFolded = true;
  /// What is known of the layers, places in the pattern's own coordinates: as a file has it.
  std::vector<DrawnOrder> orders;
  /// A folded state of this very pattern (its ids), chosen among those that were found. Goes before
  /// `orders`.
  std::shared_ptr<const FoldedState> chosen;
};

struct PatternModel {
  Model model;  ///< one step, resolved: it opens without a search
  /// How the folded state is reached; none when the model is not folded.
  std::optional<PatternWay> way;
  std::vector<std::string> notes;  ///< sentences: what was moved, left out, or cannot be
};

/// The model that a pattern means. Paper that falls into pieces beside each other keeps its largest
/// piece. A drawing that folds flat only roughly is polished first, and the farthest move is noted.
/// That the paper must bend on its way is noted in the result and in the step. Errors: BadValue -
/// an outline that no sheet can have; Cancelled.
Result<PatternModel> modelOf(const AssignedPattern& creases, const PatternModelOptions& options,
                             const Progress& progress = {});

/// An open model with every hinge that lies flat turned by what its fold last gave it: the crease
/// pattern that folds elsewhere. Where any crease is folded flat the state is folded as it is, and
/// comes back unchanged: what is flat in it may have helped on the way only. Poses and layers are
/// left as they are: for patterns only.
FoldedState asFolded(const FoldedState& state);

/// The pattern that a state is (asFolded, where `isAsFolded`): hinges with their angles, flat
/// creases F, torn and cut edges C. Ids are those of the state; curves stay curves.
AssignedPattern assignedPatternOf(const FoldedState& state, bool isAsFolded = false);

/// Which facet lies above which, for every two that overlap, facets named by places on the paper.
std::vector<DrawnOrder> drawnOrdersOf(const FoldedState& state);

}  // namespace kiri
