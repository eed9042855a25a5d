// Where places of the flat leaf lie when it is folded.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/leaf/fan.h"

namespace kiri {

/// The right half of a leaf, flat and folded; the left half is its mirror image and lies on it.
/// Both frames have the petiole as origin and the mid-vein's length as unit; +y is the mid-vein,
/// in the folded leaf that of the innermost sector, which rests. x is positive.
class FoldedHalf {
 public:
  FoldedHalf(const LeafRecipe& recipe, const std::vector<FanRay>& fan);

  /// Where a place of the flat half lies in the folded leaf, by the reflections in the creases
  /// between it and the innermost sector. Places beyond the basal edge go with its sector.
  Vec2 folded(Vec2 flat) const;
  /// The same of a place seen from the petiole: degrees from the mid-vein, and distance.
  Vec2 folded(double angle, double distance) const;
  /// A place that is seen from the junction of the secondary lobes, degrees from the outer part of
  /// the mid-vein, on the flat leaf.
  Vec2 fromJunction(double angle, double distance) const;

 private:
  struct Junction {
    double at = 0;  ///< along the vein
    double antiVein = 0;
    double vein = 0;
  };
  struct Vein {
    double angle = 0;
    double folded = 0;
    double end = 0;  ///< angle of the anti-vein behind it, to which its sectors reach
    std::vector<Junction> junctions;
  };

  std::vector<Vein> veins_;
};

/// A place at degrees clockwise from +y.
Vec2 polarPlace(double angle, double distance);

}  // namespace kiri
