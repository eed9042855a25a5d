// SPDX-License-Identifier: MIT
#include "editor/tools/curve_shape.h"

namespace kiri {

std::vector<Vec2> elevated(const std::vector<Vec2>& c) {
  if (c.size() == 2) return {c[0], lerp(c[0], c[1], 1.0 / 3), lerp(c[0], c[1], 2.0 / 3), c[1]};
  if (c.size() == 3) return {c[0], lerp(c[1], c[0], 1.0 / 3), lerp(c[1], c[2], 1.0 / 3), c[2]};
  return c;
}

std::vector<Vec2> polyline(const std::vector<Arc>& arcs, int perArc) {
  std::vector<Vec2> points;
  for (const Arc& arc : arcs) {
    for (int i = 0; i < perArc; ++i)
      points.push_back(pointAt(arc, static_cast<double>(i) / perArc));
  }
  if (!arcs.empty()) points.push_back(arcs.back().end);
  return points;
}

std::vector<Arc> splineOf(const std::vector<Vec2>& controls, bool isClosed) {
  if (controls.size() < leastControls(isClosed)) return {};
  return isClosed ? closedSpline(controls) : openSpline(controls, SplineEnds::Clamped);
}

}  // namespace kiri
