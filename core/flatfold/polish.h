// Drawings are precise to some digits; polished, they fold flat to the kernel's precision.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"

namespace kiri {

/// A pattern whose vertices were moved as little as makes it fold flat exactly.
struct Polished {
  AssignedPattern creases;
  double farthest = 0;  ///< the longest move, mm; 0: it folded exactly as drawn
};

/// Moves the vertices of a pattern until all its loops of creases close when it is folded flat.
/// Vertices on the border slide along it, corners of borders and cuts stay where they are; creases
/// that run straight through a vertex go on doing so where the rest allows it. A pattern that folds
/// flat within the kernel's tolerance comes back bit by bit. Least-change Gauss-Newton on the loops
/// of core/linkage. Errors: BadValue - target angles that are not flat; WouldStretch - no small
/// move does it, with the vertex that misses most and by how many degrees; TooThin - facets would
/// turn over; Cancelled.
Result<Polished> polished(const AssignedPattern& creases, const Progress& progress = {});

}  // namespace kiri
