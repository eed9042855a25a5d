// The direction that a model is looked at from.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/vec.h"

namespace kiri {

/// An orthographic view: three orthonormal axes of the model frame, right-handed (right x up =
/// toEye).
struct ViewFrame {
  Vec3 right{1, 0, 0};
  Vec3 up{0, 1, 0};
  Vec3 toEye{0, 0, 1};

  /// View coordinates of a model-frame point: mm, x to the right, y up.
  constexpr Vec2 project(Vec3 p) const { return {dot(p, right), dot(p, up)}; }
  /// How near the eye the point is, mm; only differences mean anything.
  constexpr double depth(Vec3 p) const { return dot(p, toEye); }
};

/// From +z: the x and y axes of the model frame lie as on paper.
constexpr ViewFrame frontView() { return {}; }
/// From -z, after walking round the model: left and right change places, up stays up.
constexpr ViewFrame backView() { return {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}; }

/// From any side. The model lies on a table, z up, and the eye goes round it. Azimuth, degrees:
/// where the eye stands, from the near edge of the sheet (0: at -y, 90: at +x, 180: at +y), so that
/// the model seems to turn clockwise as it grows. Elevation, degrees: how high; 90 is straight
/// above, 0 level with the table, -90 straight below. z never points down on the picture between
/// -90 and 90, and nothing flips at the poles: (0, 90) is frontView(), (180, -90) is backView().
ViewFrame viewFrom(double azimuth, double elevation);

}  // namespace kiri
