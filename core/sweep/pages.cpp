// SPDX-License-Identifier: MIT
#include "core/sweep/pages.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/geometry/convex.h"

namespace kiri {
namespace {

/// The part of a facet on one side of the axis.
struct Page {
  const Body* body = nullptr;
  Turn azimuth;
  double rHigh = 0;
  double side = 1;  ///< -1: the side against `outward`
};

/// Unit direction away from the axis in the plane of a page.
Vec3 outwardOf(const Body& body) { return normalized(Vec3{-body.normal.y, body.normal.x, 0}); }

/// Pages of nearly one azimuth.
struct Bundle {
  Turn azimuth;
  double rHigh = 0;
  std::vector<Page> pages;
};

void addPages(const Body& body, double tolerance, std::vector<Page>& pages) {
  const Vec3 outward = outwardOf(body);
  double high = 0;
  double low = 0;
  for (const Vec3 p : body.hull) {
    high = std::max(high, dot(outward, p));
    low = std::min(low, dot(outward, p));
  }
  if (high > tolerance) pages.push_back({&body, {outward.x, outward.y}, high, 1});
  if (low < -tolerance) pages.push_back({&body, {-outward.x, -outward.y}, -low, -1});
}

std::vector<Bundle> bundled(const std::vector<Body>& bodies, double tolerance) {
  std::vector<Page> pages;
  for (const Body& body : bodies) {
    if (body.stance == Stance::Page) addPages(body, tolerance, pages);
  }
  std::stable_sort(pages.begin(), pages.end(), [](const Page& a, const Page& b) {
    return a.azimuth.order() < b.azimuth.order();
  });
  std::vector<Bundle> bundles;
  for (const Page& page : pages) {
    const bool isNew = bundles.empty() || page.azimuth.chordTo(bundles.back().azimuth) > kSamePlane;
    if (isNew) bundles.push_back({page.azimuth, 0, {}});
    bundles.back().rHigh = std::max(bundles.back().rHigh, page.rHigh);
    bundles.back().pages.push_back(page);
  }
  return bundles;
}

using Polygon = std::vector<Vec2>;

class PageSearch {
 public:
  PageSearch(const FoldedState& state, const AxisFrame& frame, FirstFound& found)
      : state_(state), frame_(frame), found_(found), touch_(state.tolerance().match()) {}

  void meet(const Bundle& moving, const Bundle& resting) {
    const Turn turn = resting.azimuth.then(moving.azimuth.inverse());
    if (!isInside(turn, std::min(moving.rHigh, resting.rHigh))) return;
    if (found_.isSettledBefore(turn)) return;
    for (const Page& m : moving.pages) {
      for (const Page& f : resting.pages) {
        if (isInside(turn, std::min(m.rHigh, f.rHigh)) && meet(m, f, turn)) return;
      }
    }
  }

 private:
  bool isInside(Turn turn, double radius) const {
    return frame_.holds(turn) && radius * turn.chordTo({}) > touch_ &&
           radius * turn.chordTo(frame_.end) > touch_;
  }

  /// True when the two certainly meet.
  bool meet(const Page& m, const Page& f, Turn turn) {
    if (m.body->zLow > f.body->zHigh || f.body->zLow > m.body->zHigh) return false;
    for (const Polygon& a : footprint(m)) {
      for (const Polygon& b : footprint(f)) {
        if (!overlap(a, b, touch_) || shareHinge(m.body->facet, f.body->facet)) continue;
        const bool isCertain = overlap(a, b, kDoubtful * touch_);
        const Polygon common = intersection(a, b, 0);
        Vec2 middle;
        for (const Vec2 p : common) middle = middle + p / static_cast<double>(common.size());
        found_.add({m.body->facet,
                    f.body->facet,
                    turn,
                    {f.azimuth.cos * middle.x, f.azimuth.sin * middle.x, middle.y},
                    isCertain});
        if (isCertain) return true;
      }
    }
    return false;
  }

  bool shareHinge(FacetId a, FacetId b) const {
    const std::vector<EdgeUse>& border = state_.pattern[a].border;
    return std::any_of(border.begin(), border.end(), [&](EdgeUse use) {
      const Edge& edge = state_.pattern[use.edge];
      return edge.kind == EdgeKind::Hinge && across(edge, a) == b;
    });
  }

  /// Convex parts of a page in (r, z).
  const std::vector<Polygon>& footprint(const Page& page) {
    const auto [at, isNew] =
        footprints_.try_emplace({page.body->facet.index, page.side > 0 ? 1 : -1});
    if (!isNew) return at->second;
    const Vec3 outward = outwardOf(*page.body) * page.side;
    const Rigid& pose = state_.poseOf(page.body->facet);
    const double eps = state_.tolerance().length();
    for (const ConvexPart& part :
         convexParts(regionOf(state_.pattern, page.body->facet), state_.tolerance())) {
      Polygon polygon;
      for (const Vec2 p : part.points) {
        const Vec3 at3 = frame_.toFrame(pose.apply(p));
        polygon.push_back({dot(outward, at3), at3.z});
      }
      if (signedArea(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
      polygon = clipLeft(polygon, {0, 1}, {0, 0}, eps);
      if (polygon.size() >= 3) at->second.push_back(std::move(polygon));
    }
    return at->second;
  }

  const FoldedState& state_;
  const AxisFrame& frame_;
  FirstFound& found_;
  double touch_;
  std::map<std::pair<std::uint32_t, int>, std::vector<Polygon>> footprints_;
};

}  // namespace

void meetPages(const FoldedState& state, const std::vector<Body>& moving,
               const std::vector<Body>& resting, const AxisFrame& frame, FirstFound& found) {
  const double tolerance = state.tolerance().match();
  const std::vector<Bundle> restingBundles = bundled(resting, tolerance);
  if (restingBundles.empty()) return;
  PageSearch search(state, frame, found);
  for (const Bundle& m : bundled(moving, tolerance)) {
    for (const Bundle& f : restingBundles) search.meet(m, f);
  }
}

}  // namespace kiri
