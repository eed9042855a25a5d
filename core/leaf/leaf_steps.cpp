// The steps that the ways to make a leaf have in common, and the simplest way.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_steps.h"

#include "core/geometry/rigid.h"

namespace kiri {
namespace {

Step rayFold(const LeafPlan& plan, std::size_t ray, int side, FoldType type) {
  const std::string half = side > 0 ? "right" : "left";
  const FanRay& axis = plan.fan[ray];
  const Vec2 flap = plan.sheet.inSector(axis.angle, plan.fan[ray + 1].angle, side);
  const Vec2 petiole = plan.sheet.petiole();
  FoldStep fold;
  fold.name = half + " " + axis.name;
  fold.line = {Frame::Paper, petiole, plan.sheet.rimFrom(petiole, axis.angle, side), flap};
  fold.type = type;
  fold.layers = ChosenLayers{{{Frame::Paper, flap}}};
  fold.moving = MovingPoint{{Frame::Paper, flap}};
  return {fold, "Fold the " + half + " half along the " + axis.name, "", ""};
}

/// A point that the margin keeps: near the petiole, in the innermost sector.
Vec2 keptPlace(const LeafPlan& plan) { return plan.sheet.inSector(0, plan.fan[1].angle, 1); }

}  // namespace

std::vector<Step> openingSteps(const LeafPlan& plan) {
  const double side = plan.sheet.side();
  FoldStep fold;
  fold.name = "mid-vein";
  fold.line = {Frame::Paper, {side / 2, 0}, {side / 2, side}, std::nullopt};
  fold.type = FoldType::Mountain;
  std::vector<Step> steps = {{fold, "Fold along the mid-vein", "", ""}};
  if (plan.recipe.petiole == Petiole::OnEdge) return steps;
  const Vec2 petiole = plan.sheet.petiole();
  StraightCutStep cut;
  cut.line = {Frame::Model, petiole, plan.sheet.rimFrom(petiole, plan.fan.back().angle, 1),
              std::nullopt};
  cut.keep.places = {{Frame::Model, keptPlace(plan)}};
  steps.push_back({cut, "Cut from the petiole to the border",
                   "A straight cut through both layers along the basal edge; the wedge below the "
                   "petiole goes.",
                   ""});
  return steps;
}

std::vector<Step> rayFolds(const LeafPlan& plan, int side, FoldType type) {
  std::vector<Step> steps;
  for (std::size_t ray = 1; ray + 1 < plan.fan.size(); ++ray) {
    steps.push_back(rayFold(plan, ray, side, type));
  }
  return steps;
}

Step marginCut(const LeafPlan& plan, double turn) {
  const CosSin w = cosSinDegrees(turn);
  const Vec2 petiole = plan.sheet.petiole();
  const Vec2 centre = plan.recipe.secondary ? plan.junction() : petiole;
  const auto turned = [&](Vec2 p) {
    const Vec2 d = p - centre;
    return centre + Vec2{d.x * w.cos + d.y * w.sin, d.y * w.cos - d.x * w.sin};
  };
  CurveCutStep cut;
  for (const Vec2 p : marginControls(plan.knots)) {
    cut.controls.push_back(turned(petiole + p * plan.sheet.midVein()));
  }
  cut.keep.places = {{Frame::Model, turned(keptPlace(plan))}};
  return {cut, "Cut the margin", "One B-spline through all layers.", ""};
}

void addSimpleFolds(const LeafPlan& plan, Model& model) {
  model.steps = openingSteps(plan);
  model.steps.push_back({UnfoldStep{{"mid-vein"}, Sequence::InOrder}, "Unfold", "", ""});
  for (const int side : {1, -1}) {
    for (Step& step : rayFolds(plan, side, FoldType::Valley)) {
      model.steps.push_back(std::move(step));
    }
  }
  model.steps.push_back(
      {RefoldStep{}, "Refold along all fold lines", "Only the mid-vein was open.", ""});
  model.steps.push_back(marginCut(plan, 0));
  model.steps.push_back({UnfoldStep{{}, Sequence::Together}, "Unfold", "", ""});
}

}  // namespace kiri
