// Rigid motions: how a facet lies in the model frame.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/vec.h"

namespace kiri {

/// Cosine and sine of an angle in degrees, the same bits on every platform: exact at multiples of
/// 90, elsewhere within one unit in the last place or two. Uses no library function but sqrt and
/// floor.
struct CosSin {
  double cos = 1;
  double sin = 0;
};
CosSin cosSinDegrees(double degrees);

/// Angle of the direction (x, y) in degrees, in (-180, 180]; exact for multiples of 90.
double angleDegrees(double x, double y);

/// A rotation followed by a translation of space. As a pose it takes the paper frame (z = 0, front
/// towards +z) to the model frame. Columns `x`, `y`, `z` are the images of the axes; `origin` that
/// of (0, 0, 0).
struct Rigid {
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};
  Vec3 origin{0, 0, 0};

  Vec3 apply(Vec2 paper) const { return x * paper.x + y * paper.y + origin; }
  Vec3 apply(Vec3 p) const { return x * p.x + y * p.y + z * p.z + origin; }
  Vec3 direction(Vec2 d) const { return x * d.x + y * d.y; }
  Vec3 direction(Vec3 d) const { return x * d.x + y * d.y + z * d.z; }
  /// Paper-frame coordinates of the foot of a model-frame point in the plane of the facet.
  Vec2 pullBack(Vec3 p) const {
    const Vec3 d = p - origin;
    return {dot(d, x), dot(d, y)};
  }
  /// Normal of the front of the paper, model frame.
  Vec3 normal() const { return z; }
  constexpr bool operator==(const Rigid&) const = default;
};

/// first `b`, then `a`.
Rigid compose(const Rigid& a, const Rigid& b);

/// Rotation by `degrees`, counter-clockwise seen against `unitAxis`, about the line through
/// `point`. A rotation by 180 degrees is computed as a reflection in the line; multiples of 90 use
/// no sine.
Rigid rotationAbout(Vec3 point, Vec3 unitAxis, double degrees);

Rigid translation(Vec3 by);

}  // namespace kiri
