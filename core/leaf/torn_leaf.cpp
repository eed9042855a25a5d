// Secondary lobes by tearing, as the thesis makes them (Fig 7.4).
// SPDX-License-Identifier: MIT
#include "core/base/text.h"
#include "core/leaf/leaf_steps.h"
#include "core/leaf/segments.h"

namespace kiri {
namespace {

/// A fold of one half along a crease from the junction; everything below goes along.
Step secondaryFold(const LeafPlan& plan, const char* name, double angle, int side, bool isOnSheet) {
  const std::string half = side > 0 ? "right" : "left";
  const Vec2 flap = plan.outermost(side);
  const Vec2 junction = plan.junction();
  FoldStep fold;
  fold.name = half + " " + name;
  fold.line = {Frame::Paper, junction, plan.sheet.rimFrom(junction, angle, side), std::nullopt};
  if (!isOnSheet) fold.line.facet = flap;
  fold.type = side > 0 ? FoldType::Valley : FoldType::Mountain;
  fold.layers = ChosenLayers{{{Frame::Paper, flap}}};
  fold.moving = MovingPoint{{Frame::Paper, flap}};
  return {fold, "Fold the " + half + " half along the " + std::string(name),
          isOnSheet ? "Figure 7.4c. The torn half turns about the junction; the crease will run to "
                      "the sinus between mid-lobe and secondary lobe."
                    : "Figures 7.4d and 7.4e. Back again, so that the two folds make a tuck; the "
                      "crease will run to the tip of the secondary lobe.",
          ""};
}

/// On a whole sheet the creases run to its border, and none may meet another on the way.
Status checkApart(const LeafPlan& plan) {
  const LeafSheet& sheet = plan.sheet;
  const double angle = plan.recipe.secondary.front().vein.angle;
  const Vec2 end = sheet.rimFrom(plan.junction(), angle, 1);
  for (std::size_t ray = 1; ray < plan.fan.size(); ++ray) {
    const Vec2 rim = sheet.rimFrom(sheet.petiole(), plan.fan[ray].angle, 1);
    if (!doSegmentsCross(plan.junction(), end, sheet.petiole(), rim)) continue;
    return Error{ErrorCode::BadValue,
                 "the secondary vein of the mid-lobe (" + text(angle) + " degrees) meets the " +
                     plan.fan[ray].name + " (" + text(plan.fan[ray].angle) +
                     " degrees) inside the sheet, so neither can be folded; make it steeper, or "
                     "leave out \"torn\": on a sheet cut around the blade they stay apart"};
  }
  return std::monostate{};
}

}  // namespace

Status addTornFolds(const LeafPlan& plan, Model& model) {
  if (Status status = checkApart(plan); !status) return status;
  const SecondaryLobes& lobes = plan.recipe.secondary.front();
  model.steps = openingSteps(plan);
  TearStep tear;
  tear.path.points = {plan.sheet.petiole(), plan.junction()};
  model.steps.push_back({tear, "Tear along the mid-vein up to the secondary vein",
                         "Figure 7.4b. From the petiole to the junction, so that each half can be "
                         "folded by itself: simple folds cannot make the tuck in both at once.",
                         ""});
  for (const int side : {1, -1}) {
    model.steps.push_back(
        secondaryFold(plan, "secondary anti-vein", lobes.antiVein.angle, side, true));
    model.steps.push_back(secondaryFold(plan, "secondary vein", lobes.vein.angle, side, false));
  }
  for (const int side : {1, -1}) {
    const FoldType type = side > 0 ? FoldType::Valley : FoldType::Mountain;
    for (Step& step : rayFolds(plan, side, type)) model.steps.push_back(std::move(step));
  }
  model.steps.push_back(marginCut(plan, -2 * (lobes.vein.angle - lobes.antiVein.angle)));
  model.steps.push_back(openLeaf(plan));
  model.steps.push_back(
      {MendStep{}, "Mend the tear", "Its sides lie together again: the tear cost no paper.", ""});
  return std::monostate{};
}

}  // namespace kiri
