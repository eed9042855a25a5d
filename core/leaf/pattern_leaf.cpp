// Secondary lobes without a tear: all creases fold at once, as in the bud.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/base/text.h"
#include "core/geometry/tolerance.h"
#include "core/leaf/leaf_steps.h"

namespace kiri {
namespace {

constexpr double kFullFoldAngle = 180;

class PatternMaker {
 public:
  std::uint32_t vertex(Vec2 p) {
    step_.vertices.push_back(p);
    return static_cast<std::uint32_t>(step_.vertices.size() - 1);
  }
  /// Veins are mountains, anti-veins valleys, all of them: their pairs balance at the junction.
  void crease(std::uint32_t from, std::uint32_t to, bool isVein) {
    step_.creases.push_back({from, to, isVein ? Assignment::Mountain : Assignment::Valley,
                             isVein ? -kFullFoldAngle : kFullFoldAngle});
  }
  PatternStep& step() { return step_; }

 private:
  PatternStep step_;
};

/// Where two segments that start apart cross, if they do.
bool doCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 ab = b - a;
  const Vec2 cd = d - c;
  const double turn = cross(ab, cd);
  if (std::abs(turn) <= kParallel * length(ab) * length(cd)) return false;
  const double t = cross(c - a, cd) / turn;
  const double u = cross(c - a, ab) / turn;
  return t >= 0 && t <= 1 && u >= 0 && u <= 1;
}

/// The creases of secondary lobes must leave the sheet before they meet the first anti-vein.
Status checkApart(const LeafPlan& plan) {
  const LeafSheet& sheet = plan.sheet;
  const SecondaryLobes& lobes = *plan.recipe.secondary;
  const Vec2 vein = sheet.rimFrom(plan.junction(), lobes.vein.angle, 1);
  const Vec2 ray = sheet.rimFrom(sheet.petiole(), plan.fan[1].angle, 1);
  if (!doCross(plan.junction(), vein, sheet.petiole(), ray)) return std::monostate{};
  return Error{ErrorCode::BadValue,
               "the secondary vein (" + text(lobes.vein.angle) + " degrees) meets the first " +
                   "anti-vein (" + text(plan.fan[1].angle) +
                   " degrees) inside the sheet; make it " +
                   "steeper, move the anti-vein outward, or ask for a tear (\"torn\": true)"};
}

}  // namespace

Status addPattern(const LeafPlan& plan, Model& model) {
  if (Status status = checkApart(plan); !status) return status.error();
  const LeafSheet& sheet = plan.sheet;
  const SecondaryLobes& lobes = *plan.recipe.secondary;
  PatternMaker maker;
  maker.step().name = "vein";
  const std::uint32_t petiole = maker.vertex(sheet.petiole());
  const std::uint32_t junction = maker.vertex(plan.junction());
  maker.crease(petiole, junction, true);
  maker.crease(junction, maker.vertex({sheet.side() / 2, sheet.side()}), true);
  for (const int side : {1, -1}) {
    const Vec2 from = plan.junction();
    maker.crease(junction, maker.vertex(sheet.rimFrom(from, lobes.antiVein.angle, side)), false);
    maker.crease(junction, maker.vertex(sheet.rimFrom(from, lobes.vein.angle, side)), true);
    for (std::size_t ray = 1; ray + 1 < plan.fan.size(); ++ray) {
      const Vec2 rim = sheet.rimFrom(sheet.petiole(), plan.fan[ray].angle, side);
      maker.crease(petiole, maker.vertex(rim), plan.fan[ray].kind == RayKind::Vein);
    }
  }
  maker.step().isFolded = true;
  maker.step().resting = sheet.inSector(0, plan.fan[1].angle, 1);
  model.steps.push_back(
      {maker.step(), "Fold along all veins and anti-veins",
       "Figure 7.4g without the tear of Figure 7.4b: all at once, as the leaf lies in the bud. At "
       "the junction six creases hold each other, so none of them folds alone.",
       ""});
  model.steps.push_back(marginCut(plan, 0));
  model.steps.push_back(openLeaf(plan, Sequence::Together));
  if (plan.recipe.petiole == Petiole::OnEdge) return std::monostate{};
  model.sheet.shape = SheetSpec::Shape::Polygon;
  model.sheet.outline = sheet.outlineWithoutWedge(plan.fan.back().angle);
  return std::monostate{};
}

}  // namespace kiri
