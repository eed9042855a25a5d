// Following fold angles along the solutions of the closure equations.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/linkage/closure.h"
#include "core/linkage/rigid_path.h"

namespace kiri {

/// The path from closed `start` angles by prediction and correction: see rigidPath. `closure` has
/// the free hinges of the request as unknowns, `loose` the driven ones too.
RigidPath continuedPath(const FoldAngles& start, const PathRequest& request,
                        std::shared_ptr<const Closure> closure, const Closure& loose,
                        const Progress& progress);

/// `angles` with the driven hinges where they are at `part` of their way from `start`.
void drive(FoldAngles& angles, const FoldAngles& start, const PathRequest& request, double part);

/// Puts angles that are beyond 180 degrees by rounding at 180.
void putFullOnes(FoldAngles& angles);

}  // namespace kiri
