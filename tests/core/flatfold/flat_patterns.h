// Flat patterns of known answers, for the tests of this room.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/creases/assigned_pattern.h"
#include "tests/support/pattern_text.h"

namespace kiri::test {

/// A pattern from vertices and edges: all hinges are folded and unassigned but those of angle 0,
/// which are flat. `kind` of an edge with paper on both sides: a hinge or a cut.
AssignedPattern unassignedPattern(const std::vector<Vec2>& vertices,
                                  const std::vector<DrawnEdge>& edges,
                                  const std::vector<Vec2>& holes = {});

/// A sheet of columns x rows unit squares, all creases folded.
AssignedPattern mapPattern(int columns, int rows);
/// A square of side 2 with four flaps of the given length at its sides (guide: 2.3).
AssignedPattern plusPattern(double length);
/// The square twist on [-3, 3]^2 (guide: 2.3).
AssignedPattern squareTwist();

/// tiles x tiles square twists of side 6, every other one mirrored so that their pleats meet.
AssignedPattern twistTessellation(int tiles);
/// A square of side 4 with a square hole of side 1 in its left half, folded along its middle.
AssignedPattern windowPattern();

/// Gives every crease of one edge of the list a mountain or valley.
void assign(AssignedPattern& creases, EdgeId edge, Assignment assignment);

}  // namespace kiri::test
