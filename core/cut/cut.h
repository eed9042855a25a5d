// Cutting along a chain of lines and curves through chosen layers, exactly (thesis 4.4).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// A cut as scissors make it: along the chain, from end to end, through the layers. `chain` and
/// `keepSides` are in the plane of `frame`: x and y of that rigid motion.
struct CutRequest {
  Rigid frame;  ///< the pose of `facet`, or where a cut through all planes is drawn
  std::optional<FacetId> facet;  ///< whose paper frame it is; none: no facet's
  std::vector<Arc>
      chain;  ///< each arc starts where the last one ended; closed when it ends where it starts
  std::vector<FacetId> layers;  ///< facets in the plane of `frame`; those in other planes are cut
                                ///< along its normal, and must not stand upright on it
  std::vector<Vec2>
      keepSides;  ///< all paper on the same side of the cut as one of these stays, in all layers
  std::vector<Vec2>
      keepPieces;  ///< paper frame of the sheet: the connected pieces that hold one of these stay
};

/// The state after the cut. With nothing to keep named, all paper stays. Paper that hangs on a part
/// goes with it; paper that the cut does not reach stays. Errors: CurveCrossesItself; MissesPaper -
/// no layer is cut; DoesNotSeparate - paper goes round an end of the cut or past it in a layer that
/// was not cut; NotFound - a place to keep holds no paper; NothingLeft; BadValue - a layer stands
/// upright on the plane of the cut.
Result<FoldedState> cut(const FoldedState& state, const CutRequest& request);

}  // namespace kiri
