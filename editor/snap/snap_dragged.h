// What a place is meant to be to which paper is dragged.
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/snap/snap.h"

namespace kiri {

/// Where the paper that was taken at `from` (paper frame of `frame`) is laid: as snapPoint.
/// Besides, where no angle steps are asked for, a place on an edge is caught where it lies from
/// `from` in a direction of 22.5 degrees or a multiple, in which folders lay corners onto edges.
/// Such directions catch nothing away from edges.
std::optional<Snapped> snapDragged(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                   const SnapSettings& settings, FacetId frame, Vec2 from);

}  // namespace kiri
