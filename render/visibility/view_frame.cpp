// The direction that a model is looked at from.
// SPDX-License-Identifier: MIT
#include "render/visibility/view_frame.h"

#include "core/geometry/rigid.h"

namespace kiri {

ViewFrame viewFrom(double azimuth, double elevation) {
  const CosSin a = cosSinDegrees(azimuth);
  const CosSin e = cosSinDegrees(elevation);
  return {{a.cos, a.sin, 0},
          {-e.sin * a.sin, e.sin * a.cos, e.cos},
          {e.cos * a.sin, -e.cos * a.cos, e.sin}};
}

}  // namespace kiri
