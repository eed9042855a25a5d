// Where folds that are still to be made are likely to end on an edge, for tears that go so far.
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/snap/snap.h"

namespace kiri {

/// The place near a pixel on a straight edge at which two lines meet it that a folder would fold
/// along: each through a vertex of the edge's plane (on the sheet: any vertex) that is not on the
/// edge's own line, at 22.5 degrees or a multiple to the edge. None where there is no such place
/// within half the radius of the settings, at the ends of the edge, and when snaps are off. The
/// spot is on the facet at the left of the edge.
std::optional<Snapped> snapToFoldEnd(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                     const SnapSettings& settings, EdgeId edge);

}  // namespace kiri
