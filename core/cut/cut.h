// Cutting along a chain of lines and curves through chosen layers, exactly (thesis 4.4).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// A cut as scissors make it: along the chain, from end to end, through the layers. `chain` and
/// `keepSides` are in the paper frame of `frame` (and may reach beyond that facet).
struct CutRequest {
  FacetId frame;
  std::vector<Arc>
      chain;  ///< each arc starts where the last one ended; closed when it ends where it starts
  std::vector<FacetId> layers;  ///< facets in the plane of `frame`
  std::vector<Vec2>
      keepSides;  ///< all paper on the same side of the cut as one of these stays, in all layers
  std::vector<Vec2>
      keepPieces;  ///< paper frame of the sheet: the connected pieces that hold one of these stay
};

/// The state after the cut. With nothing to keep named, all paper stays. Paper that hangs on a part
/// goes with it; paper that the cut does not reach stays. Errors: CurveCrossesItself; MissesPaper -
/// no layer is cut; DoesNotSeparate - paper goes round an end of the cut or past it in a layer that
/// was not cut; NotFound - a place to keep holds no paper; NothingLeft.
Result<FoldedState> cut(const FoldedState& state, const CutRequest& request);

}  // namespace kiri
