// From a recipe to a model with ordinary steps, in the order of the thesis (7.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/leaf/folded_half.h"
#include "core/model/model.h"

namespace kiri {

struct LeafModel {
  Model model;
  FoldedHalf half;  ///< its creases end where the tips and sinuses of the model are to be
  Vec2 petiole;     ///< on the sheet, mm; the mid-vein points along +y
};

/// The right half of the leaf as its recipe folds it, whether or not one margin can cut it. Errors:
/// those of fanOf and checkSecondaryLobes; BadValue - a length of the mid-vein that is none.
Result<FoldedHalf> foldedHalfOf(const LeafRecipe& recipe);

/// Without secondary lobes: a square sheet in whole centimetres (see LeafSheet), a fold along the
/// mid-vein, for a petiole inside a cut along the basal edges, folds along anti-veins and veins in
/// one half and then in the other, one margin through all layers, and unfolding (thesis Figures 7.2
/// and 7.3). With them: the same sheet and a tear along the mid-vein (Fig 7.4), or all creases at
/// once on a sheet cut roughly around the blade. Errors: those of foldedHalfOf, marginKnots,
/// marginCurve and bladeOutline.
Result<LeafModel> leafModelOf(const LeafRecipe& recipe);

}  // namespace kiri
