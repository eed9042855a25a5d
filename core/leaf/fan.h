// The rays of a palmate leaf, and where they come to lie when the leaf is folded.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/leaf/leaf_recipe.h"

namespace kiri {

enum class RayKind { Vein, AntiVein, BasalEdge };

/// A ray of one half of the leaf. Angles in degrees from the mid-vein, clockwise on the right half.
struct FanRay {
  RayKind kind = RayKind::Vein;
  std::string name;   ///< "mid-vein", "first anti-vein", "second vein", ..., "basal edge"
  double angle = 0;   ///< on the flat leaf
  double folded = 0;  ///< in the folded leaf: sectors are laid forth and back
  double length = 0;  ///< as part of the mid-vein's length
};

/// The rays from the mid-vein to the basal edge. Errors: BadValue - with the ray and the remedy:
/// rays missing or out of order, lengths that are none, a flap that would be folded past the
/// mid-vein into the other half. Source: thesis 3.4, 7.1.
Result<std::vector<FanRay>> fanOf(const LeafRecipe& recipe);

}  // namespace kiri
