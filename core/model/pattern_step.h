// Applying a PatternStep: creases, fold lines, folded angles and layers.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/fold/movement.h"
#include "core/model/pattern_motion.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// What comes of a pattern, and how.
struct PatternOutcome {
  FoldedState state;
  std::optional<PatternWay> way;       ///< of a folded one, where the motion was asked for
  Movements movements;                 ///< where the way is Rigid or OneByOne
  std::optional<std::string> refused;  ///< why the orders asked for were not taken
};

struct PatternRequest {
  bool wantsMotion = false;
  /// Where the step has no layers: what is known of them, taken if it is an order without a fault.
  std::vector<DrawnOrder> orders;
  Progress progress;
};

/// The sheet with the creases of a pattern, folded where the step says so. Layers that the step
/// leaves open are those of the rigid motion, where there is one that meets nothing, else they are
/// searched for. Paper through paper in a given order is noted as a collision. Errors: those of
/// creasedSheet, layersFrom and searchLayers; WouldStretch - the facets do not go together at the
/// target angles; Cancelled.
Result<PatternOutcome> foldPattern(const FoldedState& sheet, const PatternStep& step,
                                   const PatternRequest& request);

/// The same as a step is applied: `record`, where there is one, gets the movement.
Result<FoldedState> applyPattern(const FoldedState& state, const PatternStep& step,
                                 Movements* record = nullptr);

/// Writes what the step left open into it: the facet that rests, and where it is folded, the layer
/// order of `after`, the state that it led to.
void nameLayers(const FoldedState& after, PatternStep& step);

/// The name that a step gives its fold lines, without the number.
std::string linesName(const PatternStep& step);

}  // namespace kiri
