// Which part of each facet is seen (thesis 5.4, phase B, in exact and efficient form).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/ids.h"
#include "core/geometry/cubic.h"
#include "core/geometry/region.h"
#include "core/paper/folded_state.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// A piece of the boundary of a visible part, with the visible part on its left.
struct BoundaryPiece {
  Arc arc;  ///< view coordinates, mm; a part of a curved edge is an exact cubic (in perspective: of
            ///< several, see appendSeen)
  FacetId
      facet;  ///< whose edge this is: the facet itself, or one that lies over it (or ends below it)
  EdgeId edge;  ///< the edge; none where two facets pass through each other
  double from =
      0;          ///< parameter on the edge, in the edge's own direction, at the start of the piece
  double to = 0;  ///< and at its end; less than `from` when the piece runs backwards
  FacetId beyond;  ///< the facet seen on the other side; none on the silhouette

  bool isSilhouette() const { return !beyond.isValid(); }
};

/// The visible part of one facet.
struct VisibleFacet {
  FacetId facet;
  bool showsFront = true;  ///< the front of the paper is turned to the eye
  /// Closed chains of pieces: outer loops counter-clockwise, holes clockwise.
  std::vector<std::vector<BoundaryPiece>> loops;
};

/// Everything that is seen, ordered by facet. The parts are disjoint and cover the silhouette;
/// neighbours share whole pieces, so that there are no T-junctions: each piece but those of the
/// silhouette occurs once more, backwards, in the facet `beyond`.
struct VisibleRegions {
  std::vector<VisibleFacet> facets;
};

/// What is seen of `state` from the direction of `view`. Within one plane the layer order decides,
/// between planes the depth at each place. Facets seen edge-on (within 1/10000 rad) have no visible
/// part. In perspective the eye must lie outside of the model. Places nearer than tolerance.match()
/// are one. Cost: near-linear in the number of facets and of visible pieces for stacks; only facets
/// that can be seen take part in the exact step.
VisibleRegions visibleRegions(const FoldedState& state, const ViewFrame& view);

/// Area of a visible part, mm^2 in the view.
double areaOf(const VisibleFacet& facet);
/// Box of all visible parts (control points included); a point at the origin when nothing is seen.
Box boundsOf(const VisibleRegions& regions);

}  // namespace kiri
