// From a crease pattern to its flat folded states: everything in one call.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"
#include "core/flatfold/folded_ground.h"
#include "core/flatfold/layer_states.h"
#include "core/flatfold/local_conditions.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// A pattern that folds flat as a map, and the layer orders it has (none perhaps).
struct FlatFolding {
  AssignedPattern creases;
  FlatMap map;
  FoldedGround ground;
  LayerStates states;
};

/// Errors: WouldStretch - it does not fold flat (flatMapOf); BadValue - target angles that are not
/// flat; those of overlapsOf and LayerStates::find.
Result<FlatFolding> flatFold(AssignedPattern creases, const SearchLimits& limits = {},
                             const Progress& progress = {});

/// The layer order of one state, one set, facing +z.
LayerOrder layerOrderOf(const OrderProblem& problem, const LayerValues& values);

/// The state as the kernel knows it: hinges at 0, 180 or -180 (an unassigned one as its layers
/// say), the facet of the largest area at rest as on the paper, poses composed by the kernel.
/// Requires a pattern whose stretch is within the kernel's tolerance (see polish.h).
FoldedState foldedStateOf(const AssignedPattern& creases, const OrderProblem& problem,
                          const LayerValues& values);

}  // namespace kiri
