// States put together by hand, and brute-force answers to what is seen of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/paper/folded_state.h"
#include "render/visibility/view_frame.h"
#include "render/visibility/visible_regions.h"

namespace kiri::testing {

/// Facets that lie as they are told, each a piece of its own.
class StackBuilder {
 public:
  explicit StackBuilder(double sheetSize) : state_(CreasePattern(Tolerance(sheetSize))) {}

  /// Loops in the paper frame (outer one counter-clockwise, holes clockwise).
  FacetId add(const std::vector<Loop>& loops, const Rigid& pose = {});
  FacetId add(const std::vector<Vec2>& polygon, const Rigid& pose = {});
  /// The same paper, lying so that it is seen at `polygon` from the front with its back up.
  FacetId addBackUp(const std::vector<Vec2>& polygon);

  void set(LayerSet layers) { sets_.push_back(std::move(layers)); }
  /// All facets in one flat set, the first at the bottom.
  FoldedState stacked(std::vector<std::pair<FacetId, FacetId>> exceptions = {});
  FoldedState state();

 private:
  FoldedState state_;
  std::vector<LayerSet> sets_;
};

std::vector<Vec2> square(double x, double y, double side);
std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1);

/// Four arms folded onto the middle of a plus sheet, each over the next (guide/algorithms.md 2.3):
/// N, E, S, W.
FoldedState pinwheel();

/// The facet seen at a point of the view, by looking at every facet; none: nothing is there. The
/// outer optional is empty when the point is nearer than `margin` to a border, where no answer is
/// asked for.
std::optional<std::optional<FacetId>> seenAt(const FoldedState& state, const ViewFrame& view,
                                             Vec2 p, double margin);

/// Visible area of each facet of a flat state with straight edges, by cutting the plane into
/// trapezoids at every vertex and crossing. Cost: cubic; shares no code with the library but the
/// poses.
std::vector<double> areasByTrapezoids(const FoldedState& state, const ViewFrame& view);

/// The part as a region, for point location.
Region regionOf(const VisibleFacet& facet);

/// Checks what must hold of any answer: closed loops, seams in pairs, pieces on the edges they
/// name.
void expectSound(const FoldedState& state, const ViewFrame& view, const VisibleRegions& regions);

/// Compares the answer with seenAt at the middle of each of n x n pixels, and with the silhouette.
void expectEqualsPixels(const FoldedState& state, const ViewFrame& view,
                        const VisibleRegions& regions, int n);

}  // namespace kiri::testing
