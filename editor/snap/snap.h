// Help for the hand: what a point that is being drawn is meant to be (thesis 4.5, F30).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core/model/locate.h"
#include "editor/base/phrase.h"
#include "editor/view/marks.h"
#include "editor/view/pane_map.h"

namespace kiri {

enum class SnapKind { None, Vertex, Midpoint, Crossing, Division, Edge, Angle, Grid };

struct SnapSettings {
  bool isOn = true;
  bool toVertices = true;
  bool toMidpoints = true;
  bool toCrossings = true;
  bool toEdges = true;
  int divisions = 0;       ///< 1/n points along edges; below 2: none
  double angleStep = 0;    ///< degrees between the directions of drawn lines; 0: none
  double gridSpacing = 0;  ///< mm in the paper frame; 0: none
  double radius = 10;      ///< pixels
};

/// A point on the paper, or beside it in the plane of a facet, and what it was caught by.
struct Snapped {
  Spot spot;  ///< the facet whose plane it is drawn on, and the point in its paper frame
  SnapKind kind = SnapKind::None;
  Phrase label;  ///< "corner", "middle", "1/3", "22.5°"
  Marks marks;   ///< what shows the catch
};

/// What a pixel means. `frame`: the facet whose plane the point must lie in (that of the line that
/// is being drawn); none: the uppermost paper under the pixel, or that of what is caught from
/// beside the paper, or none at all when no paper is near. `from`: the start of the line, in the
/// paper frame of `frame`, for angle steps; they count from the edge that `from` lies on, else from
/// the x axis.
///
/// Caught are vertices, middles, crossings and edges that are seen; with a frame, those of its
/// plane (on the sheet, all). What is nearer wins; of what is about equally near a vertex wins over
/// a crossing, that over a middle, a middle over a division, and points over edges, directions and
/// the grid. Where an edge lies on a direction of an angle step, their meeting wins over both. The
/// point is exact: a vertex of the frame's own facet to the last bit, one of another facet of the
/// plane as the poses carry it.
std::optional<Snapped> snapPoint(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                 const SnapSettings& settings,
                                 std::optional<FacetId> frame = std::nullopt,
                                 std::optional<Vec2> from = std::nullopt);

}  // namespace kiri
