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

/// A square sheet in whole centimetres. Without secondary lobes: a fold along the mid-vein, for a
/// petiole inside a cut along the basal edges, folds along anti-veins and veins in one half and
/// then in the other, one margin through all layers, and unfolding (thesis Figures 7.2 and 7.3).
/// With them: all creases at once, on a sheet without the wedge below the petiole, or with a tear
/// (Fig 7.4). Errors: those of fanOf and marginKnots; BadValue - a length of the mid-vein that is
/// none, creases that meet inside the sheet.
Result<LeafModel> leafModelOf(const LeafRecipe& recipe);

}  // namespace kiri
