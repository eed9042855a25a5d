// Loops of arcs as loops of points, the same points for both neighbours of an arc.
// SPDX-License-Identifier: MIT
#include "render/mesh/flattened.h"

#include <algorithm>

namespace kiri {
namespace {

bool isBefore(Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

}  // namespace

double meshChordError(const Tolerance& tolerance) {
  constexpr double kCoarser = 4;
  return kCoarser * tolerance.flattening();
}

std::vector<Vec2> flattened(const Arc& arc, const std::vector<double>& breaks, double chordError) {
  if (!arc.isCurved && breaks.empty()) return {arc.start, arc.end};
  const bool isBackwards = isBefore(arc.end, arc.start) ||
                           (arc.end == arc.start && isBefore(arc.control2, arc.control1));
  const Arc forth = isBackwards ? reversed(arc) : arc;
  std::vector<Vec2> points;
  if (arc.isCurved) {
    const std::vector<double> parameters = flatteningParameters(forth, chordError);
    points.reserve(parameters.size());
    for (const double t : parameters) points.push_back(pointAt(forth, t));
    points.front() = forth.start;
    points.back() = forth.end;
  } else {
    points.push_back(forth.start);
    for (std::size_t i = 0; i < breaks.size(); ++i) {
      const double t = isBackwards ? 1 - breaks[breaks.size() - 1 - i] : breaks[i];
      points.push_back(lerp(forth.start, forth.end, t));
    }
    points.push_back(forth.end);
  }
  if (isBackwards) std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace kiri
