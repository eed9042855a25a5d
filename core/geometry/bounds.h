// The least boxes that hold points and arcs.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/geometry/cubic.h"

namespace kiri {

/// The least box that holds both.
constexpr Box joined(const Box& box, Vec2 p) { return joined(box, Box{p, p}); }

/// The least box that holds the points, one or more.
constexpr Box boundsOf(std::span<const Vec2> points) {
  Box box{points.front(), points.front()};
  for (const Vec2 p : points) box = joined(box, p);
  return box;
}

/// A box that holds the arcs, one or more: that of their control points.
inline Box boundsOf(std::span<const Arc> arcs) {
  Box box = boundsOf(arcs.front());
  for (const Arc& arc : arcs) box = joined(box, boundsOf(arc));
  return box;
}

/// True when the point lies in the box or no farther than `margin` from each of its sides.
constexpr bool holds(const Box& box, Vec2 p, double margin) {
  return areNear(box, Box{p, p}, margin);
}

}  // namespace kiri
