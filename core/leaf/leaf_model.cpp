// From a recipe to a model with ordinary steps, in the order of the thesis (7.1).
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_model.h"

#include <cmath>

#include "core/leaf/leaf_steps.h"

namespace kiri {

namespace {

/// The fan of a recipe that can be folded.
Result<std::vector<FanRay>> foldableFan(const LeafRecipe& recipe) {
  if (!(std::isfinite(recipe.midVein) && recipe.midVein > 0)) {
    return Error{ErrorCode::BadValue, "the mid-vein needs a length in mm above 0"};
  }
  Result<std::vector<FanRay>> fan = fanOf(recipe);
  if (!fan) return fan;
  if (Status status = checkSecondaryLobes(recipe, *fan); !status) return status.error();
  return fan;
}

}  // namespace

Result<FoldedHalf> foldedHalfOf(const LeafRecipe& recipe) {
  const Result<std::vector<FanRay>> fan = foldableFan(recipe);
  if (!fan) return fan.error();
  return FoldedHalf(recipe, *fan);
}

Result<LeafModel> leafModelOf(const LeafRecipe& recipe) {
  const Result<std::vector<FanRay>> fan = foldableFan(recipe);
  if (!fan) return fan.error();
  const FoldedHalf half(recipe, *fan);
  const Result<std::vector<MarginKnot>> knots = marginKnots(recipe, half);
  if (!knots) return knots.error();
  const Result<MarginCurve> curve = marginCurve(half, *knots);
  if (!curve) return curve.error();
  const LeafPlan plan{recipe, *fan, half, *curve, LeafSheet(recipe, half, *curve)};
  LeafModel leaf{{}, half, plan.sheet.petiole()};
  Model& model = leaf.model;
  model.title = recipe.title;
  model.notes = recipe.notes;
  model.sheet.width = plan.sheet.width();
  model.sheet.height = plan.sheet.height();
  if (model.sheet.width != model.sheet.height) model.sheet.shape = SheetSpec::Shape::Rectangle;
  model.front = recipe.front;
  model.back = recipe.back;
  if (recipe.secondary.empty()) {
    addSimpleFolds(plan, model);
  } else {
    const Status status = isTorn(recipe) ? addTornFolds(plan, model) : addPattern(plan, model);
    if (!status) return status.error();
  }
  if (!isTorn(recipe)) model.opening = Sequence::Together;
  return leaf;
}

}  // namespace kiri
