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
/// Requires a pattern whose stretch is within the kernel's tolerance (see polished).
FoldedState foldedStateOf(const AssignedPattern& creases, const OrderProblem& problem,
                          const LayerValues& values);

/// The same pattern with its vertices moved as little as makes it fold flat exactly: drawings are
/// precise to some digits, the kernel to 1e-9 of the sheet. Vertices on the border slide along it;
/// straight creases stay straight, corners of the sheet stay where they are. Gauss-Newton on the
/// closing of all loops. Errors: WouldStretch - no small move does it, with the vertex that misses
/// most and by how many degrees; TooThin - facets would turn over.
struct Polished {
  AssignedPattern creases;
  double farthest = 0;  ///< the longest move, mm; 0: it folded exactly as drawn
};
Result<Polished> polished(const AssignedPattern& creases, const Progress& progress = {});

}  // namespace kiri
