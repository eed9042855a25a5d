// What to draw, in mm, before anyone has chosen a file format.
// SPDX-License-Identifier: MIT
#include "render/scene/scene.h"

namespace kiri {

Affine compose(const Affine& first, const Affine& second) {
  const Vec2 x = first.direction({second.a, second.b});
  const Vec2 y = first.direction({second.c, second.d});
  const Vec2 origin = first.apply({second.e, second.f});
  return {x.x, x.y, y.x, y.y, origin.x, origin.y};
}

Arc transformed(const Affine& map, const Arc& arc) {
  if (!arc.isCurved) return Arc::line(map.apply(arc.start), map.apply(arc.end));
  return Arc::cubic(map.apply(arc.start), map.apply(arc.control1), map.apply(arc.control2),
                    map.apply(arc.end));
}

}  // namespace kiri
