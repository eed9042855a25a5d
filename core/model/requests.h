// From steps to what the kernel's operations are asked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/cut/cut.h"
#include "core/cut/tear.h"
#include "core/fold/fold.h"
#include "core/model/locate.h"
#include "core/model/step.h"

namespace kiri {

/// The name a fold step gives its fold line. Where a step without a name finds it taken,
/// foldRequest goes on to the next number that is free.
std::string foldName(const FoldStep& step, int number);

/// Errors of all: what a step asks for that this state does not have, see locate.h; BadValue -
/// numbers out of range.
Result<FoldRequest> foldRequest(const FoldedState& state, const FoldStep& step, int number);
Result<CutRequest> cutRequest(const FoldedState& state, const StraightCutStep& step);
Result<CutRequest> cutRequest(const FoldedState& state, const CurveCutStep& step);
/// The fold lines named, or all; in the order of folding.
Result<std::vector<FoldLineId>> lineGroup(const FoldedState& state,
                                          const std::vector<FoldLineName>& names);

/// A path with its points snapped to vertices, and the choice of layers along it.
struct EdgeRequest {
  EdgePath path;
  EdgeChoice choice;
};
Result<EdgeRequest> edgeRequest(const FoldedState& state, const DrawnPath& path,
                                const LayerChoice& layers);

}  // namespace kiri
