// Loops of arcs as loops of points, the same points for both neighbours of an arc.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/cubic.h"
#include "core/geometry/region.h"
#include "core/geometry/tolerance.h"

namespace kiri {

/// How far chords of the mesh may lie from their curves, mm: a fraction of a pixel, also when one
/// looks closely.
double meshChordError(const Tolerance& tolerance);

/// The points of an arc, both ends included. `breaks`, parameters between 0 and 1 in rising order,
/// become points of a straight arc as well. The same arc run backwards with its breaks mirrored
/// gives the same points, bit for bit.
std::vector<Vec2> flattened(const Arc& arc, const std::vector<double>& breaks, double chordError);

}  // namespace kiri
