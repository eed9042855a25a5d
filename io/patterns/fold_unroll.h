// Unfolding a folded form by its faces.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "io/patterns/fold_graph.h"

namespace kiri {

/// The faces rolled out in the plane, each beside the one that it shares an edge with, and the
/// edges there; tells what was done. Faces keep their shape and their order of vertices. Vertices
/// are new: where paper is cut, or does not lie flat, one becomes several. Without assignments the
/// fold angles of the form are taken. Errors: BadFile, the end of a sentence whose subject is the
/// frame - no faces.
Result<FoldGraph> unrolled(const FoldGraph& form, std::vector<std::string>& notes);

}  // namespace kiri
