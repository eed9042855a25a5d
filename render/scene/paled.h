// Paper paled for what is drawn on it.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/scene/appearance.h"

namespace kiri {

/// The appearance with `white` (0: nothing, 1: all) of white mixed into the front and without its
/// texture, so that lines, marks and numbers stand out.
Appearance paledFor(const Appearance& appearance, double white = 0.85);

}  // namespace kiri
