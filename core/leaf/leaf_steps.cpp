// The steps that the ways to make a leaf have in common, and the simplest way.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_steps.h"

#include "core/geometry/rigid.h"

namespace kiri {
namespace {

/// Why a ray is folded, and where its folds are shown.
std::string rayNotes(const LeafPlan& plan, const FanRay& ray, int side) {
  const std::string what =
      ray.kind == RayKind::Vein
          ? "All that lies beyond it turns back outward: the crease will run to the tip of a lobe."
          : "All that lies beyond it turns over onto the leaf: the crease will run to a sinus.";
  const std::string mirror =
      "As on the right half, in a mirror: the halves must lie on each other "
      "for one margin to cut both.";
  return figure(plan, side > 0 ? "Figures 7.2c to 7.2f" : "Before Figure 7.2g",
                side > 0 ? "Figure 7.3b" : "Before Figure 7.3c", "Figure 7.4f") +
         (side > 0 ? what : mirror);
}

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
  return {fold, "Fold the " + half + " half along the " + axis.name, rayNotes(plan, axis, side),
          ""};
}

/// A point that the margin keeps: near the petiole, in the innermost sector.
Vec2 keptPlace(const LeafPlan& plan) { return plan.sheet.inSector(0, plan.fan[1].angle, 1); }

}  // namespace

std::string figure(const LeafPlan& plan, const std::string& onEdge, const std::string& inside,
                   const std::string& torn) {
  const bool isOnEdge = plan.recipe.petiole == Petiole::OnEdge;
  const std::string& letter = !plan.recipe.secondary.empty() ? torn : isOnEdge ? onEdge : inside;
  return letter.empty() ? "" : letter + ". ";
}

std::vector<Step> openingSteps(const LeafPlan& plan) {
  const double middle = plan.sheet.width() / 2;
  FoldStep fold;
  fold.name = "mid-vein";
  fold.line = {Frame::Paper, {middle, 0}, {middle, plan.sheet.height()}, std::nullopt};
  fold.type = FoldType::Mountain;
  std::vector<Step> steps = {
      {fold, "Fold along the mid-vein",
       figure(plan, "Figure 7.2b", "Figure 7.3a", "Figure 7.4a") +
           "The sheet is halved; whatever is done to both halves from now on makes them alike.",
       ""}};
  if (plan.recipe.petiole == Petiole::OnEdge) return steps;
  const Vec2 petiole = plan.sheet.petiole();
  StraightCutStep cut;
  cut.line = {Frame::Model, petiole, plan.sheet.rimFrom(petiole, plan.fan.back().angle, 1),
              std::nullopt};
  cut.keep.places = {{Frame::Model, keptPlace(plan)}};
  steps.push_back({cut, "Cut from the petiole to the border",
                   figure(plan, "", "Figure 7.3a", "") +
                       "A straight cut through both layers along the basal edge. The wedge below "
                       "the petiole goes, so that the creases end at a border and need not hold "
                       "each other.",
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
  const Vec2 centre = plan.junction();
  const auto turned = [&](Vec2 p) {
    const Vec2 d = p - centre;
    return centre + Vec2{d.x * w.cos + d.y * w.sin, d.y * w.cos - d.x * w.sin};
  };
  CurveCutStep cut;
  for (const Vec2 p : plan.curve.controls) {
    cut.controls.push_back(turned(petiole + p * plan.sheet.midVein()));
  }
  cut.keep.places = {{Frame::Paper, keptPlace(plan)}};
  return {cut, "Cut the margin",
          figure(plan, "Figures 7.2h and 7.2i", "Figures 7.3c and 7.3d", "Figures 7.4h and 7.4i") +
              "One B-spline through all layers. Where it crosses a vein there will be the tip of a "
              "lobe, where it crosses an anti-vein a sinus.",
          ""};
}

Step openLeaf(const LeafPlan& plan) {
  return {UnfoldStep{{}, Sequence::Together}, "Unfold the leaf",
          figure(plan, "Figure 7.2j", "Figure 7.3e", "Figure 7.4j") +
              "All fold lines open; each layer was a part of one lobe.",
          ""};
}

void addSimpleFolds(const LeafPlan& plan, Model& model) {
  model.steps = openingSteps(plan);
  model.steps.push_back({UnfoldStep{{"mid-vein"}, Sequence::InOrder}, "Unfold the mid-vein",
                         "The crease stays and says where the halves meet; each half is now folded "
                         "by itself.",
                         ""});
  for (const int side : {1, -1}) {
    for (Step& step : rayFolds(plan, side, FoldType::Valley)) {
      model.steps.push_back(std::move(step));
    }
  }
  model.steps.push_back({RefoldStep{}, "Refold along all fold lines",
                         figure(plan, "Figure 7.2g", "Figure 7.3c", "") +
                             "Only the mid-vein was open. Now all veins lie to one side and all "
                             "anti-veins to the other, as in the bud.",
                         ""});
  model.steps.push_back(marginCut(plan, 0));
  model.steps.push_back(openLeaf(plan));
}

}  // namespace kiri
