// On which side of a line a point lies, decided without rounding.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/vec.h"

namespace kiri {

/// +1 when c lies left of the line from a to b, -1 when right, 0 when the three are collinear:
/// exact for the stored doubles. Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic
/// (1997); differs: one exact stage only.
int orientation(Vec2 a, Vec2 b, Vec2 c);

}  // namespace kiri
