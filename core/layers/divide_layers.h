// Drawing edges through several layers at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"
#include "core/paper/pattern_edit.h"

namespace kiri {

/// Inscribes edges into each of the facets and divides them; new facets lie as the old ones did.
/// `inscribed` puts the edges into the pattern it is given; its errors end the work. Returns the
/// number of new edges.
using Inscribed = std::function<Result<std::vector<NewEdge>>(CreasePattern&, FacetId)>;
Result<std::size_t> divideLayers(FoldedState& state, const std::vector<FacetId>& facets,
                                 const Inscribed& inscribed);

}  // namespace kiri
