// Layers lifted off each other, for pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/paper/folded_state.h"

namespace kiri {

/// A copy for pictures only, in which each layer lies `gap` mm above the one below it, along the
/// normal of its plane; facets side by side stay level (layerLevels). With `isJoined` strips of
/// paper close the steps at the hinges, as if it bent around: they are facets after those of the
/// state. Facets keep their numbers, but hinges no longer hold together: nothing but a picture may
/// be made of it.
FoldedState spread(const FoldedState& state, double gap, bool isJoined);

}  // namespace kiri
