// Writes the steps of a leaf.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_model.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rigid.h"
#include "core/leaf/margin.h"

namespace kiri {
namespace {

/// Paper that is left around the leaf, as part of the mid-vein's length.
constexpr double kRoom = 0.08;
constexpr double kCentimetre = 10;
/// Where facets are named, as part of the shortest ray: near the petiole, where all sectors are.
constexpr double kNear = 0.3;

/// Writes the steps for one recipe.
class LeafSteps {
 public:
  LeafSteps(const LeafRecipe& recipe, const std::vector<FanRay>& fan);
  Model model() const;

 private:
  /// A point of the paper at an angle from the mid-vein; `side` 1 is the right half, -1 the left.
  Vec2 at(double angle, double length, int side) const;
  /// Where a ray leaves the sheet.
  Vec2 rimAt(double angle, int side) const;

  Step midVein() const;
  Step openBase() const;
  Step foldAlong(std::size_t ray, int side) const;
  Step margin() const;

  const LeafRecipe& recipe_;
  const std::vector<FanRay>& fan_;
  double side_ = 0;  ///< of the sheet, mm
  Vec2 petiole_;
  double near_ = 0;
};

LeafSteps::LeafSteps(const LeafRecipe& recipe, const std::vector<FanRay>& fan)
    : recipe_(recipe), fan_(fan) {
  double wide = 0;
  double low = 0;
  double shortest = 1;
  for (const FanRay& ray : fan) {
    const CosSin w = cosSinDegrees(ray.angle);
    wide = std::max(wide, ray.length * w.sin);
    low = std::max(low, -ray.length * w.cos);
    shortest = std::min(shortest, ray.length);
  }
  const bool isInside = recipe.petiole == Petiole::Inside;
  const double high = 1 + kRoom + (isInside ? low + kRoom : 0);
  const double needed = std::max(2 * (wide + kRoom), high) * recipe.midVein;
  side_ = std::ceil(needed / kCentimetre) * kCentimetre;
  const double spare = side_ - high * recipe.midVein;
  petiole_ = {side_ / 2, isInside ? (low + kRoom) * recipe.midVein + spare / 2 : 0};
  near_ = kNear * shortest * recipe.midVein;
}

Vec2 LeafSteps::at(double angle, double length, int side) const {
  const CosSin w = cosSinDegrees(angle);
  return petiole_ + Vec2{side * w.sin, w.cos} * length;
}

Vec2 LeafSteps::rimAt(double angle, int side) const {
  const CosSin w = cosSinDegrees(angle);
  const double toSide = w.sin > 0 ? side_ / 2 / w.sin : 2 * side_;
  const double toTop = w.cos > 0 ? (side_ - petiole_.y) / w.cos : 2 * side_;
  const double toBottom = w.cos < 0 ? petiole_.y / -w.cos : 2 * side_;
  return at(angle, std::min({toSide, toTop, toBottom}), side);
}

Step LeafSteps::midVein() const {
  FoldStep fold;
  fold.name = "mid-vein";
  fold.line = {Frame::Paper, {side_ / 2, 0}, {side_ / 2, side_}, std::nullopt};
  fold.type = FoldType::Mountain;
  return {fold, "Fold along the mid-vein", "", ""};
}

Step LeafSteps::openBase() const {
  StraightCutStep cut;
  cut.line = {Frame::Model, petiole_, rimAt(fan_.back().angle, 1), std::nullopt};
  cut.keep.places = {{Frame::Model, at(fan_[1].angle / 2, near_, 1)}};
  return {cut, "Cut from the petiole to the border",
          "A straight cut through both layers along the basal edge; the wedge below the petiole "
          "goes.",
          ""};
}

Step LeafSteps::foldAlong(std::size_t ray, int side) const {
  const std::string half = side > 0 ? "right" : "left";
  const FanRay& axis = fan_[ray];
  const Vec2 flap = at((axis.angle + fan_[ray + 1].angle) / 2, near_, side);
  FoldStep fold;
  fold.name = half + " " + axis.name;
  fold.line = {Frame::Paper, petiole_, rimAt(axis.angle, side), flap};
  fold.layers = ChosenLayers{{{Frame::Paper, flap}}};
  fold.moving = MovingPoint{{Frame::Paper, flap}};
  return {fold, "Fold the " + half + " half along the " + axis.name, "", ""};
}

Step LeafSteps::margin() const {
  CurveCutStep cut;
  for (const Vec2 p : marginControls(fan_)) {
    cut.controls.push_back(petiole_ + p * recipe_.midVein);
  }
  cut.keep.places = {{Frame::Model, at(fan_[1].angle / 2, near_, 1)}};
  return {cut, "Cut the margin", "One B-spline through all layers.", ""};
}

Model LeafSteps::model() const {
  Model model;
  model.title = recipe_.title;
  model.notes = recipe_.notes;
  model.sheet.width = side_;
  model.front = recipe_.front;
  model.back = recipe_.back;
  model.opening = Sequence::Together;
  model.steps.push_back(midVein());
  if (recipe_.petiole == Petiole::Inside) model.steps.push_back(openBase());
  model.steps.push_back({UnfoldStep{{"mid-vein"}, Sequence::InOrder}, "Unfold", "", ""});
  for (const int side : {1, -1}) {
    for (std::size_t ray = 1; ray + 1 < fan_.size(); ++ray) {
      model.steps.push_back(foldAlong(ray, side));
    }
  }
  model.steps.push_back(
      {RefoldStep{}, "Refold along all fold lines", "Only the mid-vein was open.", ""});
  model.steps.push_back(margin());
  model.steps.push_back({UnfoldStep{{}, Sequence::Together}, "Unfold", "", ""});
  return model;
}

}  // namespace

Result<LeafModel> leafModelOf(const LeafRecipe& recipe) {
  if (!(std::isfinite(recipe.midVein) && recipe.midVein > 0)) {
    return Error{ErrorCode::BadValue, "the mid-vein needs a length in mm above 0"};
  }
  Result<std::vector<FanRay>> fan = fanOf(recipe);
  if (!fan) return fan.error();
  LeafModel leaf;
  leaf.fan = std::move(*fan);
  leaf.model = LeafSteps(recipe, leaf.fan).model();
  return leaf;
}

}  // namespace kiri
