// SPDX-License-Identifier: MIT
#include "core/layers/order_by_height.h"

#include <cmath>
#include <optional>

#include "core/geometry/convex.h"
#include "core/layers/merge_orders.h"
#include "core/layers/plane_view.h"

namespace kiri {
namespace {

/// Facets that lie in one plane, in the order in which they are found.
struct Plane {
  Vec3 normal;
  Vec3 point;
  std::vector<FacetId> facets;
};

std::vector<Plane> planesOf(const FoldedState& state, const std::vector<Rigid>& poses) {
  std::vector<Plane> planes;
  // In the order of the old lists: facets of one plane that do not overlap keep their listing.
  for (const LayerSet& set : state.layers.sets()) {
    for (const FacetId f : set.upward) {
      const Rigid& pose = poses[f.index];
      const CreasePattern& pattern = state.pattern;
      const Vec3 p = pose.apply(pattern[startOf(pattern, pattern[f].border.front())]);
      Plane* home = nullptr;
      for (Plane& plane : planes) {
        const bool isSame =
            length(cross(plane.normal, pose.normal())) <= kSamePlane &&
            std::abs(dot(plane.normal, p - plane.point)) <= state.tolerance().match();
        if (home == nullptr && isSame) home = &plane;
      }
      if (home == nullptr) {
        const bool agrees = dot(set.normal, state.poseOf(f).normal()) > 0;
        home = &planes.emplace_back(Plane{agrees ? pose.normal() : -pose.normal(), p, {}});
      }
      home->facets.push_back(f);
    }
  }
  return planes;
}

class Heights {
 public:
  Heights(const FoldedState& state, const std::vector<Rigid>& poses,
          const std::vector<Rigid>& before)
      : state_(state), poses_(poses), before_(before) {}

  LayerSet ordered(const Plane& plane) {
    LayerSet listed{plane.normal, plane.facets, {}};
    if (plane.facets.size() < 2) return listed;
    const Rigid& reference = poses_[plane.facets.front().index];
    PlaneView view(state_.pattern, poses_, reference);
    std::vector<AbovePair> pairs;
    for (std::size_t i = 0; i < plane.facets.size(); ++i) {
      for (std::size_t j = i + 1; j < plane.facets.size(); ++j) {
        const FacetId a = plane.facets[i];
        const FacetId b = plane.facets[j];
        const std::optional<Vec2> place = commonPlace(view, a, b);
        if (!place) continue;
        const Vec3 p = reference.apply(*place);
        pairs.push_back(isAbove(plane.normal, a, b, p) ? AbovePair{a, b} : AbovePair{b, a});
      }
    }
    return mergedOrder(listed, {plane.normal, {}, {}}, pairs);
  }

 private:
  /// A point well inside the ground that both facets cover; none when they do not overlap.
  std::optional<Vec2> commonPlace(PlaneView& view, FacetId a, FacetId b) const {
    const double eps = state_.tolerance().length();
    std::optional<Vec2> place;
    double most = 0;
    for (const FootprintPart& p : view.footprint(a).parts) {
      for (const FootprintPart& q : view.footprint(b).parts) {
        if (!overlap(p.points, q.points, state_.tolerance().fat())) continue;
        const std::vector<Vec2> common = intersection(p.points, q.points, eps);
        const double area = common.size() < 3 ? 0 : signedArea(common);
        if (area <= most) continue;
        most = area;
        Vec2 sum;
        for (const Vec2 corner : common) sum = sum + corner;
        place = sum / static_cast<double>(common.size());
      }
    }
    return place;
  }

  /// Height that the paper of `facet` at `place` had before, along the normal of the plane.
  double heightOf(Vec3 normal, FacetId facet, Vec3 place) const {
    return dot(normal, before_[facet.index].apply(poses_[facet.index].pullBack(place)));
  }

  bool isAbove(Vec3 normal, FacetId a, FacetId b, Vec3 place) const {
    const double difference = heightOf(normal, a, place) - heightOf(normal, b, place);
    if (std::abs(difference) > state_.tolerance().match()) return difference > 0;
    if (!state_.layers.areCoplanar(a, b)) return difference > 0;
    const Vec3 old = state_.layers.sets()[state_.layers.setOf(a)].normal;
    const bool wasUp = dot(old, state_.poseOf(a).normal()) > 0;
    const bool isUp = dot(normal, poses_[a.index].normal()) > 0;
    return state_.layers.isAbove(a, b) == (wasUp == isUp);
  }

  const FoldedState& state_;
  const std::vector<Rigid>& poses_;
  const std::vector<Rigid>& before_;
};

}  // namespace

LayerOrder orderByHeight(const FoldedState& state, const std::vector<Rigid>& poses,
                         const std::vector<Rigid>& before) {
  Heights heights(state, poses, before);
  std::vector<LayerSet> sets;
  for (const Plane& plane : planesOf(state, poses)) sets.push_back(heights.ordered(plane));
  return LayerOrder(std::move(sets));
}

}  // namespace kiri
