// Layer order of facets that came to lie where they are all at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// The layer order of `state`'s pattern with its facets at `poses`, where no single axis says who
/// landed on whom. Facets of one plane that overlap are told apart by their heights at `before`,
/// the poses a moment earlier; those that lay in one plane then too keep the order that they have
/// in `state`. Cost: pairs of facets of one plane whose boxes meet.
LayerOrder orderByHeight(const FoldedState& state, const std::vector<Rigid>& poses,
                         const std::vector<Rigid>& before);

}  // namespace kiri
