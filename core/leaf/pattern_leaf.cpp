// Secondary lobes without a tear: all creases fold at once, as in the bud.
// SPDX-License-Identifier: MIT
#include <map>

#include "core/leaf/blade_outline.h"
#include "core/leaf/leaf_steps.h"

namespace kiri {
namespace {

constexpr double kFullFoldAngle = 180;

/// Draws the creases of one half after the other.
class PatternMaker {
 public:
  PatternMaker(const LeafPlan& plan, const BladeOutline& outline)
      : plan_(plan), outline_(outline) {}

  PatternStep made() {
    drawn(0, 1);  // the mid-vein belongs to both halves
    for (const int side : {1, -1}) {
      for (std::size_t i = 1; i + 1 < plan_.half.creases().size(); ++i) drawn(i, side);
    }
    return std::move(step_);
  }

 private:
  std::uint32_t vertex(Vec2 flat, int side) {
    const Vec2 place = plan_.sheet.place(flat, side);
    const auto [at, isNew] = vertices_.try_emplace(
        {place.x, place.y}, static_cast<std::uint32_t>(step_.vertices.size()));
    if (isNew) step_.vertices.push_back(place);
    return at->second;
  }
  /// A crease from where it starts, by way of the junctions on it, to the border of the sheet.
  void drawn(std::size_t i, int side) {
    const LeafCrease& crease = plan_.half.creases()[i];
    std::vector<Vec2> way = crease.junctions;
    way.insert(way.begin(), crease.isSecondary ? crease.from : Vec2{0, 0});
    way.push_back(outline_.places[outline_.ends[i]]);
    // Veins are mountains, anti-veins valleys, all of them: their pairs balance at the junctions.
    const bool isVein = crease.kind == RayKind::Vein;
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      step_.creases.push_back({vertex(way[k], side), vertex(way[k + 1], side),
                               isVein ? Assignment::Mountain : Assignment::Valley,
                               isVein ? -kFullFoldAngle : kFullFoldAngle});
    }
  }

  const LeafPlan& plan_;
  const BladeOutline& outline_;
  std::map<std::pair<double, double>, std::uint32_t> vertices_;
  PatternStep step_;
};

/// Counter-clockwise from the petiole.
std::vector<Vec2> cornersOf(const LeafPlan& plan, const BladeOutline& outline) {
  std::vector<Vec2> corners = {plan.sheet.petiole()};
  for (std::size_t i = outline.places.size(); i > 0; --i) {
    corners.push_back(plan.sheet.place(outline.places[i - 1], 1));
  }
  for (std::size_t i = 1; i < outline.places.size(); ++i) {
    corners.push_back(plan.sheet.place(outline.places[i], -1));
  }
  return corners;
}

}  // namespace

Status addPattern(const LeafPlan& plan, Model& model) {
  const Result<BladeOutline> outline = bladeOutline(plan.half, plan.curve);
  if (!outline) return outline.error();
  model.sheet.shape = SheetSpec::Shape::Polygon;
  model.sheet.outline = cornersOf(plan, *outline);
  PatternStep pattern = PatternMaker(plan, *outline).made();
  pattern.name = "vein";
  pattern.isFolded = true;
  pattern.resting = plan.sheet.inSector(0, plan.fan[1].angle, 1);
  model.steps.push_back(
      {pattern, "Fold along all veins and anti-veins",
       "Figure 7.4g without the tear of Figure 7.4b: the sheet is cut roughly around the blade, "
       "and "
       "all creases fold at once, as the leaf lies in the bud. At each junction six creases hold "
       "each other, so none of them folds alone.",
       ""});
  model.steps.push_back(marginCut(plan, 0));
  model.steps.push_back(openLeaf(plan));
  return std::monostate{};
}

}  // namespace kiri
