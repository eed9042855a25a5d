// How high in its plane each facet lies, counted in layers of paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// For each facet the number of layers between it and the ground of its plane: one more than the
/// highest of the facets below that it overlaps, 0 where there is none. Facets side by side share a
/// level, unlike ranks in a LayerSet. Facets that overlap in a ring, each over the next, cannot all
/// have higher levels than what they lie on; one pair of the ring has not. Cost: near-linear in the
/// facets of a plane, and square only in those that lie on each other.
std::vector<std::uint32_t> layerLevels(const FoldedState& state);

/// The poses of the facets with each layer lifted `gap` mm off the one below it, along the normal
/// of its plane: for pictures and solids, never for geometry. Hinges are a little apart then.
std::vector<Rigid> spreadPoses(const FoldedState& state, double gap);
/// The same, for who has the levels already.
std::vector<Rigid> spreadPoses(const FoldedState& state, double gap,
                               const std::vector<std::uint32_t>& levels);

}  // namespace kiri
