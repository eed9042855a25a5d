// Where the facets of a pattern lie when all its creases are folded flat.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"

namespace kiri {

/// A rigid motion of the plane, mirrored where the facet lies with its back up.
struct FlatPose {
  Vec2 x{1, 0};  ///< image of the paper's x axis
  Vec2 y{0, 1};
  Vec2 origin;
  bool isFlipped = false;

  Vec2 apply(Vec2 paper) const { return x * paper.x + y * paper.y + origin; }
};

struct FlatMap {
  std::vector<FlatPose> poses;  ///< by facet; the facet of the largest area lies as on the paper
  std::vector<Vec2> vertices;   ///< by vertex, folded; of disagreeing facets the first
  double error =
      0;  ///< the largest distance, mm, by which two facets disagree about an end of their hinge
};

/// Composes reflections outward along the longest creases (guide to algorithms 4.2). Errors:
/// WouldStretch - facets disagree about where they lie by more than the drawing's precision
/// explains, or about which side is up: with the hinges.
Result<FlatMap> flatMapOf(const AssignedPattern& creases);

}  // namespace kiri
