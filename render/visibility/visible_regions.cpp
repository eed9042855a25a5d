// Which part of each facet is seen (thesis 5.4, phase B, in exact and efficient form).
// SPDX-License-Identifier: MIT
#include "render/visibility/visible_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "render/visibility/arrangement.h"
#include "render/visibility/coverage.h"
#include "render/visibility/faces.h"
#include "render/visibility/facet_view.h"
#include "render/visibility/grid.h"
#include "render/visibility/occlusion.h"
#include "render/visibility/regions_of_views.h"
#include "render/visibility/seams.h"

namespace kiri {
namespace {

constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();

/// Grows with the angle clockwise from `reference` to `direction`, in (0, 4].
double clockwiseTurn(Vec2 reference, Vec2 direction) {
  const double c = dot(reference, direction);
  const double s = -cross(reference, direction);
  const double sum = std::abs(c) + std::abs(s);
  if (!(sum > 0)) return 4;
  const double turn = s >= 0 ? 1 - c / sum : 3 + c / sum;
  return turn > kParallel ? turn : 4;
}

/// Chains the seams of one facet, sorted by their start, to loops with the facet on the left.
class LoopTracer {
 public:
  explicit LoopTracer(std::vector<const HalfSeam*> seams) : seams_(std::move(seams)) {
    isUsed_.assign(seams_.size(), false);
  }

  std::vector<std::vector<BoundaryPiece>> run() {
    std::vector<std::vector<BoundaryPiece>> loops;
    for (std::size_t start = 0; start < seams_.size(); ++start) {
      if (isUsed_[start]) continue;
      std::vector<BoundaryPiece> loop;
      std::size_t at = start;
      do {
        isUsed_[at] = true;
        loop.push_back(seams_[at]->piece);
        at = successor(at, start);
      } while (at != start && at != kNoPlace);
      // A chain that does not close has no inside: it comes only from layers that contradict each
      // other.
      if (at == start) loops.push_back(std::move(loop));
    }
    return loops;
  }

 private:
  /// Of the seams that leave the end of seam `at`, the first clockwise from where it came: the
  /// facet lies between.
  std::size_t successor(std::size_t at, std::size_t start) const {
    const std::uint32_t vertex = seams_[at]->to;
    const auto byStart = [](const HalfSeam* seam, std::uint32_t v) { return seam->from < v; };
    const auto first = std::lower_bound(seams_.begin(), seams_.end(), vertex, byStart);
    const Vec2 cameFrom = startDirection(reversed(seams_[at]->piece.arc));
    std::size_t best = kNoPlace;
    double bestTurn = 5;
    for (auto it = first; it != seams_.end() && (*it)->from == vertex; ++it) {
      const auto i = static_cast<std::size_t>(it - seams_.begin());
      if (isUsed_[i] && i != start) continue;
      const double turn = clockwiseTurn(cameFrom, startDirection((*it)->piece.arc));
      if (turn < bestTurn) {
        best = i;
        bestTurn = turn;
      }
    }
    return best;
  }

  std::vector<const HalfSeam*> seams_;
  std::vector<bool> isUsed_;
};

VisibleRegions tracedRegions(const FacetViews& views, const std::vector<HalfSeam>& seams) {
  std::vector<const HalfSeam*> order;
  for (const HalfSeam& seam : seams) {
    if (seam.facet != HalfSeam::kNoFacet) order.push_back(&seam);
  }
  const auto key =
      [&](const HalfSeam* s) {  // seams lie in one array: their addresses are their order in it
        return std::tuple{views.all()[s->facet].id, s->from, s - seams.data()};
      };
  std::sort(order.begin(), order.end(),
            [&](const HalfSeam* a, const HalfSeam* b) { return key(a) < key(b); });
  VisibleRegions out;
  for (auto first = order.begin(); first != order.end();) {
    auto last = first;
    while (last != order.end() && (*last)->facet == (*first)->facet) ++last;
    const FacetView& view = views.all()[(*first)->facet];
    VisibleFacet facet{view.id, view.showsFront, LoopTracer({first, last}).run()};
    if (!facet.loops.empty()) out.facets.push_back(std::move(facet));
    first = last;
  }
  return out;
}

}  // namespace

VisibleRegions visibleRegions(const FoldedState& state, const ViewFrame& view) {
  return regionsOfViews(FacetViews(state, view));
}

VisibleRegions regionsOfViews(const FacetViews& views) {
  const std::vector<std::uint32_t> inSight = facetsInSight(views);
  const Arrangement map = arrange(views, inSight);
  std::vector<SeenBeside> seen = seenBesideSides(views, inSight, map);
  settleFaces(map, seen);
  return tracedRegions(views, seamsOf(views, map, seen));
}

double areaOf(const VisibleFacet& facet) {
  double twice = 0;
  for (const auto& loop : facet.loops) {
    for (const BoundaryPiece& piece : loop) twice += doubleArea(piece.arc);
  }
  return twice / 2;
}

Box boundsOf(const VisibleRegions& regions) {
  bool isEmpty = true;
  Box box;
  for (const VisibleFacet& facet : regions.facets) {
    for (const auto& loop : facet.loops) {
      for (const BoundaryPiece& piece : loop) {
        box = isEmpty ? boundsOf(piece.arc) : joined(box, boundsOf(piece.arc));
        isEmpty = false;
      }
    }
  }
  return box;
}

}  // namespace kiri
