// The direction, and the place of the eye, that a model is looked at from.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/vec.h"

namespace kiri {

/// A view: three orthonormal axes of the model frame, right-handed (right x up = toEye).
/// Orthographic, or in perspective with the eye above `centre`. Either way planes stay planes and
/// straight lines straight; what lies in the plane through the centre appears in true size.
struct ViewFrame {
  Vec3 right{1, 0, 0};
  Vec3 up{0, 1, 0};
  Vec3 toEye{0, 0, 1};
  Vec3 centre{};           ///< perspective only, model frame
  double eyeDistance = 0;  ///< mm from the centre to the eye; 0: orthographic

  constexpr bool isPerspective() const { return eyeDistance > 0; }
  constexpr Vec3 eye() const { return centre + toEye * eyeDistance; }
  /// How much larger things near the point appear than in the plane through the centre; negative
  /// behind the eye.
  constexpr double enlargement(Vec3 p) const {
    return isPerspective() ? eyeDistance / (eyeDistance - dot(p - centre, toEye)) : 1;
  }
  /// View coordinates of a model-frame point: mm, x to the right, y up.
  constexpr Vec2 project(Vec3 p) const {
    if (!isPerspective()) return direction(p);
    return direction(centre) + direction(p - centre) * enlargement(p);
  }
  /// View coordinates of a model-frame direction, perspective left aside.
  constexpr Vec2 direction(Vec3 d) const { return {dot(d, right), dot(d, up)}; }
  /// How near the eye the point is, mm; only differences mean anything. In perspective the scale of
  /// it grows towards the eye in such a way that it is linear over each projected plane.
  constexpr double depth(Vec3 p) const {
    return isPerspective() ? dot(p - centre, toEye) * enlargement(p) : dot(p, toEye);
  }
  /// Where the line of sight through a point of the view meets a plane that is not seen edge-on.
  Vec3 onPlane(Vec2 p, Vec3 point, Vec3 normal) const;
  /// Positive when a plane through `p` turns this unit normal to the eye; 1 when it turns it
  /// straight there.
  constexpr double facing(Vec3 normal, Vec3 p) const {
    return isPerspective() ? dot(normal, eye() - p) / eyeDistance : dot(normal, toEye);
  }
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
