// Sectors are laid forth and back; beyond a junction three more reflections.
// SPDX-License-Identifier: MIT
#include "core/leaf/folded_half.h"

#include <cmath>

#include "core/geometry/rigid.h"

namespace kiri {
namespace {

Vec2 turnedClockwise(Vec2 p, double degrees) {
  const CosSin w = cosSinDegrees(degrees);
  return {p.x * w.cos + p.y * w.sin, p.y * w.cos - p.x * w.sin};
}

}  // namespace

Vec2 polarPlace(double angle, double distance) {
  const CosSin w = cosSinDegrees(angle);
  return Vec2{w.sin, w.cos} * distance;
}

FoldedHalf::FoldedHalf(const LeafRecipe& recipe, const std::vector<FanRay>& fan) {
  for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
    if (fan[i].kind == RayKind::Vein) {
      veins_.push_back({fan[i].angle, fan[i].folded, fan[i + 1].angle, {}});
    }
  }
  if (!recipe.secondary) return;
  const SecondaryLobes& lobes = *recipe.secondary;
  veins_.front().junctions.push_back({lobes.at, lobes.antiVein.angle, lobes.vein.angle});
}

Vec2 FoldedHalf::folded(Vec2 flat) const {
  return folded(angleDegrees(flat.y, flat.x), length(flat));
}

Vec2 FoldedHalf::folded(double angle, double distance) const {
  std::size_t i = 0;
  while (i + 1 < veins_.size() && angle > veins_[i].end) ++i;
  const Vein& vein = veins_[i];
  // Both sectors of a vein lie on its outer side.
  Vec2 place = polarPlace(std::abs(angle - vein.angle), distance);
  for (const Junction& junction : vein.junctions) {
    const Vec2 from = place - Vec2{0, junction.at};
    const double seen = angleDegrees(from.y, from.x);
    if (seen >= junction.vein) continue;
    Vec2 laid = polarPlace(2 * junction.vein - seen, length(from));
    if (seen < junction.antiVein) {
      laid = turnedClockwise(from, 2 * (junction.vein - junction.antiVein));
    }
    place = Vec2{0, junction.at} + laid;
  }
  return turnedClockwise(place, vein.folded);
}

Vec2 FoldedHalf::fromJunction(double angle, double distance) const {
  return Vec2{0, veins_.front().junctions.front().at} + polarPlace(angle, distance);
}

}  // namespace kiri
