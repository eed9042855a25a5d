// Comparing how paper lies in two states.
// SPDX-License-Identifier: MIT
#include "editor/session/moved_facets.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "render/visibility/grid.h"

namespace kiri {

namespace {

/// Finds facets by places of the sheet without looking at all of them.
class PaperIndex {
 public:
  explicit PaperIndex(const CreasePattern& pattern)
      : pattern_(pattern), boxes_(boxesOf(pattern)), grid_(gridOver(boxes_)) {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      grid_.addBox(boxes_[i], static_cast<std::uint32_t>(i));
    }
  }

  std::optional<FacetId> at(Vec2 paper) const {
    const double near = pattern_.tolerance.pick();
    std::optional<FacetId> touched;
    std::optional<FacetId> found;
    grid_.visit({paper - Vec2{near, near}, paper + Vec2{near, near}}, [&](std::uint32_t i) {
      if (found) return;
      const FacetId facet{std::size_t{i}};
      const Where where = locate(regionOf(pattern_, facet), paper, pattern_.tolerance.length());
      if (where == Where::Inside) found = facet;
      if (where == Where::OnBorder && !touched) touched = facet;
    });
    return found ? found : touched;
  }

 private:
  static std::vector<Box> boxesOf(const CreasePattern& pattern) {
    std::vector<Box> boxes;
    boxes.reserve(pattern.facets.size());
    for (std::size_t i = 0; i < pattern.facets.size(); ++i) {
      boxes.push_back(boundsOf(regionOf(pattern, FacetId(i))));
    }
    return boxes;
  }
  static Grid gridOver(const std::vector<Box>& boxes) {
    Box all{{0, 0}, {1, 1}};
    Vec2 size{1, 1};
    if (!boxes.empty()) {
      all = boxes.front();
      Vec2 sum;
      for (const Box& box : boxes) {
        all = joined(all, box);
        sum = sum + (box.high - box.low);
      }
      size = sum / static_cast<double>(boxes.size());
    }
    return Grid(all, size, boxes.size());
  }

  const CreasePattern& pattern_;
  std::vector<Box> boxes_;
  Grid grid_;
};

bool liesAlike(const Rigid& a, const Rigid& b, const Box& box, double tolerance) {
  const Vec2 corners[] = {box.low, {box.high.x, box.low.y}, {box.low.x, box.high.y}};
  return std::all_of(std::begin(corners), std::end(corners), [&](Vec2 corner) {
    return distance(a.apply(corner), b.apply(corner)) <= tolerance;
  });
}

}  // namespace

std::vector<bool> movedFacets(const FoldedState& before, const FoldedState& after) {
  const PaperIndex index(before.pattern);
  std::vector<bool> moved(after.pattern.facets.size(), true);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const FacetId facet(i);
    const std::optional<FacetId> was = index.at(interiorPointOf(after.pattern, facet));
    if (!was) continue;
    moved[i] = !liesAlike(before.poseOf(*was), after.poseOf(facet),
                          boundsOf(regionOf(after.pattern, facet)), after.tolerance().match());
  }
  return moved;
}

std::vector<FacetId> facetsHolding(const CreasePattern& pattern, const std::vector<Vec2>& places) {
  std::vector<FacetId> found;
  if (places.empty()) return found;
  const PaperIndex index(pattern);
  for (const Vec2 place : places) {
    if (const std::optional<FacetId> facet = index.at(place)) found.push_back(*facet);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace kiri
