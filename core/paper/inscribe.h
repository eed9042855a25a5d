// Drawing lines and curves into facets: where they enter, leave and end.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/paper/pattern_edit.h"

namespace kiri {

/// The parts of a chain of arcs (paper frame, each starting where the last ended) that lie inside a
/// facet, ready for divideFacet. Crossed edges of the facet are split; meeting points within
/// tolerance.length() of a vertex are that vertex. Parts that run along the border are left out. A
/// chain that ends inside the facet ends there.
std::vector<NewEdge> inscribe(CreasePattern& pattern, FacetId facet, const std::vector<Arc>& chain,
                              EdgeKind kind);

/// The chords of a facet along the infinite line through `from` and `to`, those only that the
/// segment from `from` to `to` shares a stretch with. Nothing is changed. t0 < t1 are in units of
/// the segment (0 at from, 1 at to).
struct Chord {
  double t0 = 0;
  double t1 = 0;
};
std::vector<Chord> chordsOf(const CreasePattern& pattern, FacetId facet, Vec2 from, Vec2 to);

/// Inscribes the chords as straight edges. Errors: TooThin - a corner lies so near beside the line
/// that a sliver would be left, with the corner.
Result<std::vector<NewEdge>> inscribeChords(CreasePattern& pattern, FacetId facet, Vec2 from,
                                            Vec2 to, EdgeKind kind);

}  // namespace kiri
