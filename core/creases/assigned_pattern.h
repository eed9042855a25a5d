// A crease pattern with what each of its edges is meant to become.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/creases/crease_drawing.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// A planar map and one assignment an edge. `pattern` is as a kernel state needs it: every hinge
/// has two different facets. `pattern[e].angle` is the target angle: 180 valley, -180 mountain, 0
/// flat or join, what the file says otherwise; an unassigned hinge has +180 and its sign means
/// nothing.
struct AssignedPattern {
  explicit AssignedPattern(CreasePattern p) : pattern(std::move(p)) {}

  CreasePattern pattern;
  std::vector<Assignment> assignments;  ///< by edge

  Assignment of(EdgeId e) const { return assignments[e.index]; }
  /// True when the edge is a hinge that folds by 180 degrees, in whichever direction.
  bool isFolded(EdgeId e) const {
    return pattern[e].kind == EdgeKind::Hinge && pattern[e].angle != 0;
  }
};

/// True when every target angle is 0, 180 or -180: a pattern that is meant to fold flat.
bool isMeantFlat(const AssignedPattern& creases);

}  // namespace kiri
