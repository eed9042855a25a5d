// The sheet that holds a leaf, and places on it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/leaf/folded_half.h"
#include "core/leaf/margin.h"

namespace kiri {

/// The least square, in whole centimetres (small ones finer), that holds the leaf with some room,
/// and whose corners no crease runs into; a little higher than wide where a square would have such
/// corners however large. Sides: 1 is the right half of the leaf, -1 the left. Lengths in mm.
class LeafSheet {
 public:
  LeafSheet(const LeafRecipe& recipe, const FoldedHalf& half, const MarginCurve& curve);

  double width() const { return width_; }
  double height() const { return height_; }
  double midVein() const { return midVein_; }
  Vec2 petiole() const { return petiole_; }
  /// A place of the flat right half (see FoldedHalf), or its mirror image in the left.
  Vec2 place(Vec2 flat, int side) const;
  /// A point at an angle from the mid-vein.
  Vec2 at(double angle, double length, int side) const;
  /// Where the ray from a point of the sheet leaves it.
  Vec2 rimFrom(Vec2 from, double angle, int side) const;
  /// A point of a sector near the petiole, where all sectors are: names its facet.
  Vec2 inSector(double fromAngle, double toAngle, int side) const;

 private:
  bool isClearOfCorners(const FoldedHalf& half) const;

  double midVein_ = 0;
  double width_ = 0;
  double height_ = 0;
  double near_ = 0;
  Vec2 petiole_;
};

}  // namespace kiri
