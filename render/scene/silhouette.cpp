// The outline of all that is seen.
// SPDX-License-Identifier: MIT
#include "render/scene/silhouette.h"

#include <map>
#include <utility>

namespace kiri {

// Pieces meet at the very same points.
std::vector<Loop> silhouetteOf(const VisibleRegions& regions) {
  std::map<std::pair<double, double>, std::vector<const Arc*>> byStart;
  for (const VisibleFacet& facet : regions.facets) {
    for (const auto& loop : facet.loops) {
      for (const BoundaryPiece& piece : loop) {
        if (piece.isSilhouette())
          byStart[{piece.arc.start.x, piece.arc.start.y}].push_back(&piece.arc);
      }
    }
  }
  std::vector<Loop> loops;
  for (auto it = byStart.begin(); it != byStart.end(); ++it) {
    while (!it->second.empty()) {
      Loop loop;
      for (auto at = it; at != byStart.end() && !at->second.empty();) {
        const Arc* arc = at->second.back();
        at->second.pop_back();
        loop.push_back(*arc);
        at = byStart.find({arc->end.x, arc->end.y});
      }
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

}  // namespace kiri
