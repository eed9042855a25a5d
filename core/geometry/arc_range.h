// How far an arc reaches in a direction.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/cubic.h"

namespace kiri {

/// Least and greatest value of dot(direction, p) over the points p of an arc, exact for curves too.
struct Range {
  double low = 0;
  double high = 0;
};
Range rangeAlong(const Arc& arc, Vec2 direction);

}  // namespace kiri
