// From a recipe to a model with ordinary steps, in the order of the thesis (7.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/leaf/fan.h"
#include "core/model/model.h"

namespace kiri {

struct LeafModel {
  Model model;
  std::vector<FanRay> fan;
};

/// The square sheet, a fold along the mid-vein, for a petiole inside a cut along the basal edges,
/// folds along anti-veins and veins in one half and then in the other, one margin through all
/// layers, and unfolding (thesis Figures 7.2 and 7.3). The sheet is the least square, in whole
/// centimetres, that holds the leaf. Errors: those of fanOf; BadValue - a length of the mid-vein
/// that is none.
Result<LeafModel> leafModelOf(const LeafRecipe& recipe);

}  // namespace kiri
