// Folding along a drawn segment (thesis 4.1, 5.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/fold/movement.h"
#include "core/paper/facet_line.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// What to fold. Left and right of the line, valley and mountain are as seen from the front of the
/// model (from the facet's own front where its plane stands upright).
struct FoldRequest {
  FacetLine line;
  std::vector<FacetId> layers;  ///< facets to crease, each crossed by the segment or along it
  bool leftMoves = true;
  std::vector<Vec2>
      companions;  ///< places on the sheet that are meant to move; an error when they do not
  bool isValley = true;
  double degrees = 180;  ///< 0 to 180
  std::string name;      ///< of the fold line
};

/// The direction "up" that left, right, valley and mountain refer to: the normal of the facet's
/// plane that looks to the viewer of the front, or the facet's own front where the plane stands
/// upright.
Vec3 upOf(const FoldedState& state, FacetId facet);

/// Creases the layers along the line and rotates the paper joined to the moving side. Facets that
/// the segment does not cross are not split; where it runs along existing flat hinges between two
/// of the layers, these become part of the fold line. Where it crosses no layer, it folds along the
/// hinges that are there, flat or folded, between a layer and another facet: the one of the two
/// that lies on the moving side turns by `degrees` from where it is, and these hinges alone become
/// a fold line of their own, which is folded as they are then (decisions, 12). Errors: MissesPaper
/// - no layer is crossed and nothing turns along the line; BadValue - hinges there are folded by
/// different angles; TooThin - see inscribeChords; WouldStretch - the moving side is joined to the
/// resting side by a hinge that is not on the line, named with a remedy; NothingToDo - a companion
/// rests. `record` gets the movement.
Result<FoldedState> fold(const FoldedState& state, const FoldRequest& request,
                         Movements* record = nullptr);

}  // namespace kiri
