// The direction that a model is looked at from.
// SPDX-License-Identifier: MIT
#include "render/visibility/view_frame.h"

#include "core/geometry/rigid.h"

namespace kiri {

Vec3 ViewFrame::onPlane(Vec2 p, Vec3 point, Vec3 normal) const {
  const Vec2 aside = p - direction(centre);
  const Vec3 onPicture = centre + right * aside.x + up * aside.y;
  const Vec3 ray = isPerspective() ? onPicture - eye() : toEye;
  return onPicture + ray * (dot(point - onPicture, normal) / dot(ray, normal));
}

ViewFrame viewFrom(double azimuth, double elevation) {
  const CosSin a = cosSinDegrees(azimuth);
  const CosSin e = cosSinDegrees(elevation);
  return {{a.cos, a.sin, 0},
          {-e.sin * a.sin, e.sin * a.cos, e.cos},
          {e.cos * a.sin, -e.cos * a.cos, e.sin}};
}

}  // namespace kiri
