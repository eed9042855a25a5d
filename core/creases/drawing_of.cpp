// A pattern as loose lines again.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/creases/repair.h"

namespace kiri {
namespace {

std::vector<Vec2> placesAlong(const CreasePattern& pattern, EdgeId edge) {
  const Arc arc = arcOf(pattern, edge);
  std::vector<Vec2> places{arc.start};
  if (arc.isCurved) {
    for (const double t : flatteningParameters(arc, pattern.tolerance.flattening())) {
      if (t > 0 && t < 1) places.push_back(pointAt(arc, t));
    }
  }
  places.push_back(arc.end);
  return places;
}

std::vector<Vec2> cornersOf(const CreasePattern& pattern, const Facet& facet) {
  const std::size_t end = facet.holeStarts.empty() ? facet.border.size() : facet.holeStarts.front();
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < end; ++i) {
    const EdgeUse use = facet.border[i];
    std::vector<Vec2> places = placesAlong(pattern, use.edge);
    if (use.isReversed) std::reverse(places.begin(), places.end());
    corners.insert(corners.end(), places.begin(), places.end() - 1);
  }
  return corners;
}

}  // namespace

CreaseDrawing drawingOf(const AssignedPattern& creases) {
  CreaseDrawing drawing;
  const CreasePattern& pattern = creases.pattern;
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    DrawnCrease line;
    line.assignment = creases.assignments[e];
    if (edge.kind == EdgeKind::Hinge && line.assignment != Assignment::Unassigned)
      line.angle = edge.angle;
    const std::vector<Vec2> places = placesAlong(pattern, EdgeId(e));
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      line.from = places[i];
      line.to = places[i + 1];
      drawing.lines.push_back(line);
    }
  }
  for (const Facet& facet : pattern.facets) drawing.faces.push_back(cornersOf(pattern, facet));
  return drawing;
}

}  // namespace kiri
