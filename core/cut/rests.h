// Where the pieces of the paper rest, after pieces were parted or joined.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// One rest for each piece: the first old one of those that lie in it, else a facet that lies as
/// one of them (a part of it), else its lowest facet as it lies. Poses are derived anew. Requires
/// poses that fit the facets.
void renewRests(FoldedState& state);

/// The state without the facets for which `keep` is false; everything else stays where it lies.
FoldedState keepOnly(const FoldedState& state, const std::vector<bool>& keep);

}  // namespace kiri
