// Along the margin the facets follow each other; every crease between them is a reflection.
// SPDX-License-Identifier: MIT
#include "core/leaf/folded_half.h"

#include <algorithm>

#include "core/leaf/secondary_lobes.h"

namespace kiri {
namespace {

constexpr double kMirrorTurn = 180;

Vec3 raised(Vec2 p) { return {p.x, p.y, 0}; }

Rigid reflectionIn(const LeafCrease& crease) {
  return rotationAbout(raised(crease.from), raised(normalized(crease.end - crease.from)),
                       kMirrorTurn);
}

/// The creases of secondary lobes on one side of a vein, in the order of the margin there.
std::vector<LeafCrease> secondaryCreases(const LeafRecipe& recipe, std::size_t lobe,
                                         const FanRay& vein, int side) {
  std::vector<LeafCrease> creases;
  for (const SecondaryLobes* pair : pairsOfLobe(recipe, lobe)) {
    const Vec2 from = polarPlace(vein.angle, pair->at * vein.length);
    const std::string of = " of " + lobeName(recipe, *pair);
    const auto crease = [&](RayKind kind, const char* name, const LeafRay& ray) {
      const Vec2 way = polarPlace(vein.angle + side * ray.angle, ray.length);
      return LeafCrease{kind, name + of, from, from + way, true, {}};
    };
    creases.push_back(crease(RayKind::Vein, "secondary vein", pair->vein));
    creases.push_back(crease(RayKind::AntiVein, "secondary anti-vein", pair->antiVein));
  }
  // The margin before a vein meets the innermost pair first, that behind it the outermost.
  if (side > 0) std::reverse(creases.begin(), creases.end());
  return creases;
}

std::vector<LeafCrease> creasesOf(const LeafRecipe& recipe, const std::vector<FanRay>& fan) {
  std::vector<LeafCrease> creases;
  const auto add = [&](const std::vector<LeafCrease>& more) {
    creases.insert(creases.end(), more.begin(), more.end());
  };
  std::size_t lobe = 0;
  for (const FanRay& ray : fan) {
    LeafCrease crease{ray.kind, ray.name, {0, 0}, polarPlace(ray.angle, ray.length), false, {}};
    if (ray.kind != RayKind::Vein) {
      creases.push_back(crease);
      continue;
    }
    for (const SecondaryLobes* pair : pairsOfLobe(recipe, lobe)) {
      crease.from = polarPlace(ray.angle, pair->at * ray.length);
      crease.junctions.push_back(crease.from);
    }
    if (lobe > 0) add(secondaryCreases(recipe, lobe, ray, -1));
    creases.push_back(crease);
    add(secondaryCreases(recipe, lobe, ray, 1));
    ++lobe;
  }
  return creases;
}

/// True when the margin meets the crease before it passes the facet of `p`. Creases from the
/// petiole: `p` lies clockwise of them. Those from a junction: it lies clockwise of them, too, and
/// not behind the junction, as seen along the vein, when they stand before their vein.
bool isBeyond(const LeafCrease& crease, const LeafCrease& vein, Vec2 p) {
  const Vec2 way = crease.end - crease.from;
  const Vec2 seen = p - crease.from;
  const bool isClockwise = cross(way, seen) < 0;
  if (!crease.isSecondary) return isClockwise;
  const Vec2 outward = normalized(vein.end);
  const bool isBehindVein = cross(outward, way) < 0;
  const bool isSeenBehind = cross(outward, seen) < 0;
  if (isBehindVein != isSeenBehind) return isSeenBehind;
  return isClockwise;
}

}  // namespace

Vec2 polarPlace(double angle, double distance) {
  const CosSin w = cosSinDegrees(angle);
  return Vec2{w.sin, w.cos} * distance;
}

FoldedHalf::FoldedHalf(const LeafRecipe& recipe, const std::vector<FanRay>& fan)
    : creases_(creasesOf(recipe, fan)), poses_(creases_.size() - 1) {
  // The innermost sector ends at the first anti-vein, or at the basal edge when there is none.
  std::size_t resting = 0;
  while (creases_[resting + 1].isSecondary) ++resting;
  for (std::size_t i = resting; i > 0; --i) {
    poses_[i - 1] = compose(poses_[i], reflectionIn(creases_[i]));
  }
  for (std::size_t i = resting + 1; i < poses_.size(); ++i) {
    poses_[i] = compose(poses_[i - 1], reflectionIn(creases_[i]));
  }
}

std::size_t FoldedHalf::facetAt(Vec2 flat) const {
  // The vein of a secondary crease is the nearest main crease that is one.
  std::size_t facet = 0;
  std::size_t vein = 0;
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    const LeafCrease& crease = creases_[i];
    if (crease.isSecondary) {
      std::size_t next = i;
      while (next < poses_.size() && creases_[next].isSecondary) ++next;
      const bool isAhead = creases_[next].kind == RayKind::Vein && !creases_[next].isSecondary;
      if (isAhead) vein = next;
    } else if (crease.kind == RayKind::Vein) {
      vein = i;
    }
    if (!isBeyond(crease, creases_[vein], flat)) break;
    facet = i;
  }
  return facet;
}

Vec2 FoldedHalf::folded(Vec2 flat) const { return flatten(poses_[facetAt(flat)].apply(flat)); }

Vec2 FoldedHalf::foldedEnd(std::size_t crease) const {
  return flatten(poses_[std::min(crease, poses_.size() - 1)].apply(creases_[crease].end));
}

std::size_t FoldedHalf::tipOf(std::size_t facet) const {
  return creases_[facet].kind == RayKind::Vein ? facet : facet + 1;
}

std::size_t FoldedHalf::sinusOf(std::size_t facet) const {
  return creases_[facet].kind == RayKind::Vein ? facet + 1 : facet;
}

}  // namespace kiri
