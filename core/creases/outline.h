// The outline of paper whose border was not drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/creases/map_faces.h"

namespace kiri {

/// True when every line has a bounded face beside it: the lines show their own outline.
bool showOutline(const MapFaces& faces, std::size_t lineCount);

/// The sides of the convex hull of all lines, as borders, counter-clockwise; empty when all lines
/// lie on one straight line.
std::vector<MapLine> hullOf(const LineMap& map);

}  // namespace kiri
