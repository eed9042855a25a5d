// The layer order of a PatternStep: places on the paper to a LayerOrder, and back.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// The layer order that the step's list and exceptions say. `state` has its poses; its layers are
/// not looked at. Its first rest is the facet that the list refers to. Errors: NotFound - a place
/// without paper, a facet that the list leaves out; BadValue - a facet named twice. With the place.
Result<LayerOrder> layersFrom(const FoldedState& state, const PatternStep& step);

/// The opposite: writes the order of `state` into the step.
void writeLayers(const FoldedState& state, PatternStep& step);

/// Every facet in the set of its plane, in the order of their numbers.
LayerOrder unorderedLayers(const FoldedState& state);

}  // namespace kiri
