// Clipping and overlap of convex polygons: the workhorse of layers and visibility.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/region.h"

namespace kiri {

/// Area of a simple polygon, positive when counter-clockwise.
double signedArea(std::span<const Vec2> polygon);

/// The part of convex `polygon` on the left of the line through `a` and `b` (points within `eps` of
/// the line are on it). Empty when nothing wider than eps is left.
std::vector<Vec2> clipLeft(std::span<const Vec2> polygon, Vec2 a, Vec2 b, double eps);

/// Intersection of two convex counter-clockwise polygons; empty when they only touch (narrower than
/// eps).
std::vector<Vec2> intersection(std::span<const Vec2> a, std::span<const Vec2> b, double eps);

/// True when the intersection is fat: its area divided by its perimeter exceeds `fat`.
bool overlap(std::span<const Vec2> a, std::span<const Vec2> b, double fat);

/// `part` cut in two by the line through `a` and `b`; the new side carries `tag`. Either half may
/// be empty (no points). Sides keep their tags.
struct ConvexHalves {
  ConvexPart left;
  ConvexPart right;
};
ConvexHalves splitConvex(const ConvexPart& part, Vec2 a, Vec2 b, std::int32_t tag, double eps);

}  // namespace kiri
