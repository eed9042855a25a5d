// Paper that is dragged back over the crease it hangs on: its fold opens.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core/model/locate.h"
#include "editor/tools/scope.h"

namespace kiri {

/// A fold that opens when the hand lets go here.
struct FlapOpening {
  std::string line;  ///< the fold line
  Vec2 place;        ///< where the held paper comes to lie, paper frame of its facet as it is now
  Vec2 from;         ///< the crease, in the same frame
  Vec2 to;
};

/// The fold that lays the held paper under the pointer when it opens, if there is one: the facet
/// moved with that fold, lies flat on it, and the pointer is within the reach of snaps. Model pane
/// only; nothing while snaps are off.
std::optional<FlapOpening> openingUnder(const Scope& scope, const Spot& held, Vec2 pixels);

}  // namespace kiri
