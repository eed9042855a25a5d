// What must hold of every state: the planar map, the poses, the isometry. Written apart from the
// kernel. SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// What is wrong with the crease pattern: loops that do not close or cross, edges that do not agree
/// with their facets, vertices too near each other, facets without area or over each other, hinges
/// that are no hinges.
std::vector<std::string> patternViolations(const CreasePattern& pattern);

/// What is wrong with the poses: no rigid motions; the two sides of a hinge more than 1e-9 of the
/// sheet apart; a dihedral angle that is not the hinge's; poses other than those found by turning
/// facets in the model frame, walking the pieces depth first.
std::vector<std::string> poseViolations(const FoldedState& state);

/// Pattern, poses, layer order, paper that stands in paper, and the lists beside them (lines,
/// rests).
std::vector<std::string> violationsOf(const FoldedState& state);

/// The largest distance between the two images of a hinge's end, mm, found from the poses as they
/// stand.
double hingeGap(const FoldedState& state);

/// One text of many, for messages.
std::string joined(const std::vector<std::string>& sentences);

}  // namespace kiri::test
