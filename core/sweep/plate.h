// A convex piece of a facet where it lies in space: how deep two cross, how far they are apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/geometry/rigid.h"

namespace kiri {

/// A convex polygon of the model frame, counter-clockwise about `normal`.
struct Plate {
  std::vector<Vec3> points;
  Vec3 normal;
  Vec3 middle;
  double radius = 0;  ///< of a ball about the middle that holds it

  double heightOf(Vec3 p) const { return dot(normal, p - points.front()); }
};

Plate plateOf(const std::vector<Vec2>& convex, const Rigid& pose);

/// By how much two plates would have to be shifted at least, roughly, not to pass through each
/// other; 0 where they do not. `place` gets a point of both, where there is one.
double crossingDepth(const Plate& a, const Plate& b, Vec3& place);

/// The distance of two plates that do not pass through each other, or a lower bound of it that is
/// at least `enough`.
double distanceBetween(const Plate& a, const Plate& b, double enough);

}  // namespace kiri
