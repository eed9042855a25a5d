// SPDX-License-Identifier: MIT
#include "editor/snap/fold_ends.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/geometry/rigid.h"
#include "editor/snap/catches.h"

namespace kiri {
namespace {

constexpr int kFolderSteps = 7;  // between 0 and 180 degrees

/// An edge's line as an axis: how far along it, and how far beside.
struct EdgeAxis {
  Vec2 from;
  Vec2 along;
  double length = 0;
};

/// A line through a vertex that meets the axis.
struct FolderLine {
  double at = 0;  ///< on the axis, mm
  int steps = 0;  ///< of 22.5 degrees
  Vec2 vertex;    ///< along and beside the axis
};

/// The vertices of the plane that the facet is seen in, in the paper frame of the facet.
std::vector<Vec2> verticesAround(const FoldedState& state, const PaneMap& map, FacetId frame) {
  const Rigid pose = map.poseOf(state, frame);
  std::vector<Vec2> places;
  for (std::uint32_t i = 0; i < state.pattern.facets.size(); ++i) {
    const FacetId facet(i);
    if (map.pane == Pane::Model && !state.layers.areCoplanar(facet, frame)) continue;
    const Rigid there = map.poseOf(state, facet);
    for (const EdgeUse use : state.pattern[facet].border) {
      const Vec2 vertex = state.pattern[startOf(state.pattern, use)];
      places.push_back(facet == frame ? vertex : pose.pullBack(there.apply(vertex)));
    }
  }
  return places;
}

/// All lines that meet the axis inside the edge, in the order of their meetings.
std::vector<FolderLine> linesOnto(const EdgeAxis& axis, const std::vector<Vec2>& places,
                                  double match) {
  std::vector<FolderLine> lines;
  for (const Vec2 place : places) {
    const Vec2 vertex{dot(place - axis.from, axis.along), cross(axis.along, place - axis.from)};
    if (std::abs(vertex.y) <= match) continue;
    for (int steps = 1; steps <= kFolderSteps; ++steps) {
      const CosSin t = cosSinDegrees(kFolderStep * steps);
      const double at = vertex.x - vertex.y * t.cos / t.sin;
      if (at > match && at < axis.length - match) lines.push_back({at, steps, vertex});
    }
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const FolderLine& a, const FolderLine& b) { return a.at < b.at; });
  return lines;
}

/// The angle to the edge, as one would measure it: at most 90 degrees.
std::string degreesOf(const FolderLine& line) {
  return text(kFolderStep * std::min(line.steps, kFolderSteps + 1 - line.steps));
}

/// Another line than the first; corners that lie on each other have the same lines.
const FolderLine* secondAt(const std::vector<FolderLine>& lines, const FolderLine& first,
                           double match) {
  for (const FolderLine& line : lines) {
    if (std::abs(line.at - first.at) <= match && line.steps != first.steps) return &line;
  }
  return nullptr;
}

}  // namespace

std::optional<Snapped> snapToFoldEnd(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                     const SnapSettings& settings, EdgeId id) {
  const Edge& edge = state.pattern[id];
  if (!settings.isOn || edge.isCurved() || !edge.left.isValid()) return std::nullopt;
  const double match = state.tolerance().match();
  const Vec2 from = state.pattern[edge.from];
  const Vec2 way = state.pattern[edge.to] - from;
  const EdgeAxis axis{from, normalized(way), length(way)};
  const std::vector<FolderLine> lines =
      linesOnto(axis, verticesAround(state, map, edge.left), match);
  const FolderLine* best = nullptr;
  const FolderLine* other = nullptr;
  double nearest = settings.radius / 2;
  for (const FolderLine& line : lines) {
    const Spot spot{edge.left, from + axis.along * line.at};
    const double away = distance(map.toPixels(state, spot), pixels);
    if (away >= nearest) continue;
    const FolderLine* second = secondAt(lines, line, match);
    if (second == nullptr) continue;
    nearest = away;
    best = &line;
    other = second;
  }
  if (best == nullptr) return std::nullopt;
  Snapped out;
  out.kind = SnapKind::Angle;
  out.spot = {edge.left, from + axis.along * best->at};
  out.label = {KIRI_TEXT("editor/snap", "%1° and %2°"), {degreesOf(*best), degreesOf(*other)}};
  const auto drawn = [&](Vec2 paper) -> MarkPlace {
    if (map.pane == Pane::Sheet)
      return PixelPlace{map.pane, map.toPixels(state, {edge.left, paper})};
    return map.placeOf(state, {edge.left, paper});
  };
  for (const FolderLine* line : {best, other}) {
    const Vec2 vertex =
        from + axis.along * line->vertex.x + perpendicular(axis.along) * line->vertex.y;
    out.marks.push_back(PathMark{MarkRole::Snap, {drawn(vertex), drawn(out.spot.paper)}});
  }
  out.marks.push_back(PointMark{MarkRole::Snap, drawn(out.spot.paper)});
  out.marks.push_back(TextMark{MarkRole::Snap, drawn(out.spot.paper), out.label});
  return out;
}

}  // namespace kiri
