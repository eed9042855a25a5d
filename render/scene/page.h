// Laying pictures out on a page.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/geometry/cubic.h"
#include "render/scene/scene.h"

namespace kiri {

/// A scaled and moved copy: the lower left corner of `box` comes to lie at `corner`.
Affine placed(const Box& box, double scale, Vec2 corner);

/// Lines of a grid `spacing` mm of paper apart, on multiples of it, over `box` (before `toScene`).
Group gridGroup(const Box& box, double spacing, const Affine& toScene);

/// The part of a straight arc that lies in the box; none when it misses it.
std::optional<Arc> clippedTo(const Box& box, const Arc& line);

}  // namespace kiri
