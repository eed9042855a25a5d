// The sheet that holds a leaf, and places on it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/leaf/fan.h"

namespace kiri {

/// The least square, in whole centimetres, that holds the leaf with some room. Sides: 1 is the
/// right half of the leaf, -1 the left. Lengths in mm.
class LeafSheet {
 public:
  LeafSheet(const LeafRecipe& recipe, const std::vector<FanRay>& fan);

  double side() const { return side_; }
  double midVein() const { return midVein_; }
  Vec2 petiole() const { return petiole_; }
  /// A point at an angle from the mid-vein.
  Vec2 at(double angle, double length, int side) const;
  /// Where the ray from a point of the sheet leaves it.
  Vec2 rimFrom(Vec2 from, double angle, int side) const;
  /// A point of a sector near the petiole, where all sectors are: names its facet.
  Vec2 inSector(double fromAngle, double toAngle, int side) const;
  /// The corners of the sheet without the wedge below the petiole, counter-clockwise from it.
  std::vector<Vec2> outlineWithoutWedge(double basalAngle) const;

 private:
  double midVein_ = 0;
  double side_ = 0;
  double near_ = 0;
  Vec2 petiole_;
};

}  // namespace kiri
