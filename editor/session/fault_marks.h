// Pointing at what is wrong: the witness of an error, the places of collisions.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"
#include "editor/view/marks.h"

namespace kiri {

/// Where an error is seen. What of the witness lies on no paper of `state` is left out.
Marks marksOf(const Witness& witness, const FoldedState& state);

/// Where paper meets paper, with the angle at which it does; once where several layers meet.
Marks marksOf(const std::vector<Collision>& collisions, const FoldedState& state);

/// The facets of `state` that collide.
std::vector<FacetId> facetsOf(const std::vector<Collision>& collisions, const FoldedState& state);

}  // namespace kiri
