// The steps that make a leaf, one of three ways.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/leaf/leaf_sheet.h"
#include "core/leaf/margin.h"
#include "core/leaf/secondary_lobes.h"
#include "core/model/model.h"

namespace kiri {

/// What the ways share.
struct LeafPlan {
  const LeafRecipe& recipe;
  const std::vector<FanRay>& fan;
  const FoldedHalf& half;
  const MarginCurve& curve;
  LeafSheet sheet;

  /// Where the secondary lobes that are torn leave the mid-vein, mm.
  Vec2 junction() const { return sheet.place(half.creases().front().from, 1); }
  /// The outermost sector of a half: what a fold nearer to the mid-vein takes along.
  Vec2 outermost(int side) const {
    return sheet.inSector(fan[fan.size() - 2].angle, fan.back().angle, side);
  }
};

/// "Fold along the mid-vein", and for a petiole inside the cut that opens the base.
std::vector<Step> openingSteps(const LeafPlan& plan);
/// Folds one half along its rays, from the mid-vein outward.
std::vector<Step> rayFolds(const LeafPlan& plan, int side, FoldType type);
/// "Figure 7.2b. ": which picture of the thesis shows a step, for a petiole on the edge or inside
/// and for torn secondary lobes; nothing where that is empty.
std::string figure(const LeafPlan& plan, const std::string& onEdge, const std::string& inside,
                   const std::string& torn);
/// Unfolds everything at once.
Step openLeaf(const LeafPlan& plan);
/// The margin through all layers. `turn`: degrees, clockwise, by which the innermost sector is
/// turned about the junction from where it lies on the sheet.
Step marginCut(const LeafPlan& plan, double turn);

/// Folds one by one (thesis Figures 7.2 and 7.3).
void addSimpleFolds(const LeafPlan& plan, Model& model);
/// With a tear along the mid-vein (thesis Fig 7.4). Errors: BadValue - creases that meet inside the
/// sheet.
Status addTornFolds(const LeafPlan& plan, Model& model);
/// All creases at once, as in the bud; no tear; on a sheet cut roughly around the blade. Errors:
/// those of bladeOutline.
Status addPattern(const LeafPlan& plan, Model& model);

}  // namespace kiri
