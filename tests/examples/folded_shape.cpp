// Hulls, counts and areas of flat models.
// SPDX-License-Identifier: MIT
#include "tests/examples/folded_shape.h"

#include <algorithm>

#include "core/geometry/hull.h"
#include "render/visibility/visible_regions.h"
#include "tests/support/plane_overlap.h"

namespace kiri::test {
namespace {

std::string cornersText(const std::vector<Vec2>& corners) {
  std::string out;
  for (const Vec2 p : corners) {
    out += " (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
  }
  return out;
}

/// Hull without corners that are there by rounding only.
std::vector<Vec2> hullOf(const FoldedState& state) {
  std::vector<Vec2> places;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    for (const EdgeUse use : state.pattern.facets[f].border) {
      const Vec3 p = state.poses[f].apply(state.pattern[startOf(state.pattern, use)]);
      places.push_back({p.x, p.y});
    }
  }
  std::vector<Vec2> hull = convexHull(std::move(places));
  const double within = 1e-9 * state.tolerance().sheetSize();
  for (std::size_t i = 0; i < hull.size();) {
    const Vec2 before = hull[(i + hull.size() - 1) % hull.size()];
    const Vec2 side = hull[(i + 1) % hull.size()] - before;
    if (std::abs(cross(side, hull[i] - before)) <= within * length(side)) {
      hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  return hull;
}

SeenAreas seen(const FoldedState& state, const ViewFrame& view) {
  SeenAreas out;
  for (const VisibleFacet& part : visibleRegions(state, view).facets) {
    (part.showsFront ? out.front : out.back) += areaOf(part);
  }
  return out;
}

}  // namespace

testing::AssertionResult hasHull(const FoldedState& state, const std::vector<Vec2>& corners) {
  const std::vector<Vec2> hull = hullOf(state);
  const double within = 1e-9 * state.tolerance().sheetSize();
  for (std::size_t turn = 0; hull.size() == corners.size() && turn < hull.size(); ++turn) {
    std::size_t same = 0;
    while (same < hull.size() &&
           distance(hull[(turn + same) % hull.size()], corners[same]) <= within) {
      ++same;
    }
    if (same == hull.size()) return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "the hull is" << cornersText(hull);
}

int layersAt(const FoldedState& state, Vec2 place) {
  const PlaneFrame table{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  int count = 0;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    const Loops loops = placed(flatLoopsOf(state.pattern, FacetId(f)), state.poses[f], table);
    count += contains(loops, place) ? 1 : 0;
  }
  return count;
}

SeenAreas seenFromFront(const FoldedState& state) { return seen(state, frontView()); }
SeenAreas seenFromBack(const FoldedState& state) { return seen(state, backView()); }

testing::AssertionResult hasVertex(const CreasePattern& pattern, Vec2 place) {
  const double within = 1e-9 * pattern.tolerance.sheetSize();
  for (const Vec2 p : pattern.vertices) {
    if (distance(p, place) <= within) return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "no vertex at" << cornersText({place});
}

}  // namespace kiri::test
