// The creases of half a leaf, and where its places lie when it is folded.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/rigid.h"
#include "core/leaf/fan.h"

namespace kiri {

/// A crease of the right half that the margin ends: a main vein or anti-vein, one of a secondary
/// lobe, or the basal edge.
struct LeafCrease {
  RayKind kind = RayKind::Vein;
  std::string name;
  Vec2 from;  ///< the petiole, or the junction where it leaves its main vein
  Vec2 end;   ///< the tip or sinus
  bool isSecondary = false;
  std::vector<Vec2> junctions;  ///< of a main vein: where pairs leave it, from the petiole outward
};

/// The right half of a leaf, flat and folded; the left half is its mirror image and lies on it.
/// Both frames have the petiole as origin and the mid-vein's length as unit; +y is the mid-vein,
/// in the folded leaf that of the innermost sector, which rests. x is positive.
class FoldedHalf {
 public:
  /// `recipe` must be one that fanOf and checkSecondaryLobes let pass.
  FoldedHalf(const LeafRecipe& recipe, const std::vector<FanRay>& fan);

  /// In the order in which the margin meets them, from the mid-vein to the basal edge: tips and
  /// sinuses by turns.
  const std::vector<LeafCrease>& creases() const { return creases_; }
  /// How the facet between creases i and i + 1 lies in the folded leaf: by the reflections in the
  /// creases between it and the innermost sector.
  const Rigid& pose(std::size_t facet) const { return poses_[facet]; }
  /// The facet that holds a place of the flat half.
  std::size_t facetAt(Vec2 flat) const;
  /// Where a place of the flat half lies in the folded leaf.
  Vec2 folded(Vec2 flat) const;
  /// Where the end of a crease lies.
  Vec2 foldedEnd(std::size_t crease) const;
  /// The vein and the anti-vein (or basal edge) between which a facet lies.
  std::size_t tipOf(std::size_t facet) const;
  std::size_t sinusOf(std::size_t facet) const;

 private:
  std::vector<LeafCrease> creases_;
  std::vector<Rigid> poses_;
};

/// A place at degrees clockwise from +y.
Vec2 polarPlace(double angle, double distance);

}  // namespace kiri
