// The sheet that holds a leaf, and places on it.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/bounds.h"
#include "core/geometry/rigid.h"

namespace kiri {
namespace {

/// Paper that is left around the leaf, as part of the mid-vein's length.
constexpr double kRoom = 0.08;
constexpr double kCentimetre = 10;
/// Sides are whole centimetres, of small leaves tenths or hundredths: this part of the side at
/// most.
constexpr double kCoarse = 0.1;
/// A fold line that ends nearer than this part of the width to a corner would be drawn to the
/// corner.
constexpr double kCorner = 0.005;
constexpr int kMostTries = 20;
/// Where facets are named, as part of the shortest ray.
constexpr double kNear = 0.3;
constexpr int kPlacesPerPiece = 4;

/// What the right half covers, in lengths of the mid-vein.
Box bladeBox(const FoldedHalf& half, const MarginCurve& curve) {
  Box box{{0, 0}, {0, 1}};
  for (std::size_t facet = 0; facet + 1 < half.creases().size(); ++facet) {
    for (const Vec2 p : marginOfFacet(half, curve, facet, kPlacesPerPiece)) {
      box = joined(box, p);
    }
  }
  return box;
}

}  // namespace

LeafSheet::LeafSheet(const LeafRecipe& recipe, const FoldedHalf& half, const MarginCurve& curve)
    : midVein_(recipe.midVein) {
  const Box blade = bladeBox(half, curve);
  const double wide = blade.high.x;
  const double low = std::max(0.0, -blade.low.y);
  double shortest = 1;
  for (const LeafCrease& crease : half.creases()) {
    shortest = std::min(shortest, length(crease.end));
    if (!crease.junctions.empty()) shortest = std::min(shortest, length(crease.junctions.front()));
  }
  const bool isInside = recipe.petiole == Petiole::Inside;
  const double high = 1 + kRoom + (isInside ? low + kRoom : 0);
  const double needed = std::max(2 * (wide + kRoom), high) * midVein_;
  near_ = kNear * shortest * midVein_;
  double step = kCentimetre;
  while (step > needed * kCoarse) step /= 10;
  const double least = std::ceil(needed / step);
  for (int more = 0; more < kMostTries; ++more) {
    // From the middle of a side a larger square looks the same; only a higher sheet does not.
    width_ = (isInside ? least + more : least) * step;
    height_ = (least + more) * step;
    const double spare = height_ - high * midVein_;
    petiole_ = {width_ / 2, isInside ? (low + kRoom) * midVein_ + spare / 2 : 0};
    if (isClearOfCorners(half)) break;
  }
}

bool LeafSheet::isClearOfCorners(const FoldedHalf& half) const {
  return std::all_of(half.creases().begin(), half.creases().end(), [&](const LeafCrease& crease) {
    // With the petiole on the border of the sheet the basal edge is that border.
    if (crease.kind == RayKind::BasalEdge && petiole_.y == 0) return true;
    const Vec2 way = crease.end - crease.from;
    const Vec2 end = rimFrom(place(crease.from, 1), angleDegrees(way.y, way.x), 1);
    return distance(end, {width_, height_}) > kCorner * width_ &&
           distance(end, {width_, 0}) > kCorner * width_;
  });
}

Vec2 LeafSheet::place(Vec2 flat, int side) const {
  return petiole_ + Vec2{side * flat.x, flat.y} * midVein_;
}

Vec2 LeafSheet::at(double angle, double length, int side) const {
  const CosSin w = cosSinDegrees(angle);
  return petiole_ + Vec2{side * w.sin, w.cos} * length;
}

Vec2 LeafSheet::rimFrom(Vec2 from, double angle, int side) const {
  const CosSin w = cosSinDegrees(angle);
  const double far = 2 * (width_ + height_);
  const double toSide = w.sin > 0 ? (width_ / 2 - side * (from.x - width_ / 2)) / w.sin : far;
  const double toTop = w.cos > 0 ? (height_ - from.y) / w.cos : far;
  const double toBottom = w.cos < 0 ? from.y / -w.cos : far;
  const double reach = std::min({toSide, toTop, toBottom});
  Vec2 end = from + Vec2{side * w.sin, w.cos} * reach;
  // On the rim exactly, so that the end is no corner beside it.
  if (reach == toSide) end.x = side > 0 ? width_ : 0;
  if (reach == toTop) end.y = height_;
  if (reach == toBottom) end.y = 0;
  return end;
}

Vec2 LeafSheet::inSector(double fromAngle, double toAngle, int side) const {
  return at((fromAngle + toAngle) / 2, near_, side);
}

}  // namespace kiri
