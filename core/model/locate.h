// From places, names and drawn lines to the facets and fold lines of one state.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/fold/fold.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// A facet and a point in its paper frame.
struct Spot {
  FacetId facet;
  Vec2 paper;
};

/// The paper at a place; in the model frame the topmost there. Errors: NotFound - no paper there.
Result<Spot> locatePlace(const FoldedState& state, const Place& place);

/// The line in the frame of a facet. Ends within tolerance.pick() of a vertex are that vertex. In
/// the model frame the topmost paper under the line's middle gives the plane (else under other
/// points of it). Errors: MissesPaper - no paper under the line; BadValue - no length; NotFound -
/// nothing at `facet`.
Result<FacetLine> locateLine(const FoldedState& state, const DrawnLine& line);

/// The facets that a layer choice means for a line: all facets of the line's plane, those among the
/// topmost along it, or the chosen ones. Errors: NotFound; BadValue - a chosen facet lies in
/// another plane, a count below 1.
Result<std::vector<FacetId>> locateLayers(const FoldedState& state, const LayerChoice& choice,
                                          const FacetLine& line);

/// The facets of places. Errors: NotFound.
Result<std::vector<FacetId>> locateFacets(const FoldedState& state,
                                          const std::vector<Place>& places);

/// Errors: NotFound - with the names there are.
Result<FoldLineId> locateFoldLine(const FoldedState& state, const FoldLineName& name);

/// A place in the plane of `frame`, in its paper frame (which may lie beyond the paper).
Vec2 onPlaneOf(const FoldedState& state, FacetId frame, Vec2 model);

/// The vertex of the frame's plane within tolerance.pick() of a point of it, in the paper frame of
/// `frame`; else the point itself.
Vec2 snapToVertex(const FoldedState& state, FacetId frame, Vec2 point);

/// Height of a facet in its plane as the viewer of the front counts, 0 at the bottom.
double heightOf(const FoldedState& state, FacetId facet);

}  // namespace kiri
