// Tearing along existing edges, and mending (thesis 4.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// Where edges are looked for: along a polyline on the sheet, or along one drawn on the folded
/// model seen from the front (x and y of the model frame).
struct EdgePath {
  bool isOnPaper = true;
  std::vector<Vec2> points;
};

/// Which of the edges that lie along the path are meant.
struct EdgeChoice {
  std::optional<int> top;                        ///< the uppermost so many along the path
  std::optional<std::vector<FacetId>> ofFacets;  ///< those that belong to one of these facets
  bool isOwnOnly = false;  ///< a path on the sheet: those that it runs along, none elsewhere
};                         ///< none of them: all layers

/// Tears the hinges along the path; where it starts or ends between the ends of a hinge, that hinge
/// is divided there. A path on the sheet means, for all layers, also the hinges that lie at the
/// same place of the model. Errors: NothingToDo - a stretch of the path has no edge along it, with
/// the stretch.
Result<FoldedState> tear(const FoldedState& state, const EdgePath& path, const EdgeChoice& choice);

/// Joins torn edges again, the inverse of tear: along the path, or (empty path) all whose sides lie
/// together. A hinge that comes back folded against its fold line (a tuck) turns that way with the
/// line from then on. Errors: NothingToDo - no torn edge there; CannotMend - the two sides have
/// moved apart, with the place.
Result<FoldedState> mend(const FoldedState& state, const EdgePath& path, const EdgeChoice& choice);

}  // namespace kiri
