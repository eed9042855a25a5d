// The edges around a pixel, and what is seen of them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "editor/view/neighbourhood.h"

namespace kiri {

bool SeenPlaces::has(FacetId facet, Vec2 pixels) {
  constexpr double kCells = 1 << 16;  // a pixel, each way: far finer than a hand, above rounding
  const std::pair key{std::round(pixels.x * kCells), std::round(pixels.y * kCells)};
  auto at = known_.find(key);
  if (at == known_.end()) at = known_.emplace(key, near_.seenAround(pixels)).first;
  return std::find(at->second.begin(), at->second.end(), facet) != at->second.end();
}

EdgePoint pointOf(const EdgeInView& edge, double t, const Neighbourhood& near, Vec2 pixels) {
  const Vec2 paper = pointAt(arcOf(near.state().pattern, edge.use), edge.seen.onPaper(t));
  const Vec2 at = near.map().toPixels(near.state(), {edge.facet, paper});
  return {t, paper, at, distance(at, pixels)};
}

std::optional<EdgePoint> nearestSeen(const EdgeInView& edge, const Neighbourhood& near,
                                     SeenPlaces& seen, Vec2 pixels, double radius, double from) {
  constexpr int kPoints = 24;
  constexpr int kHalvings = 16;
  const double span = lengthOf(edge.seen.arc, radius / near.map().pixelsPerMm);
  // Only so much of the edge can be within the radius, on either side of the nearest point.
  const double within = 2 * radius / near.map().pixelsPerMm;
  const double reach = span > within ? within / span : 1;
  std::optional<EdgePoint> best;
  for (const double side : {-1.0, 1.0}) {
    double hidden = from;
    for (int i = 1; i <= kPoints; ++i) {
      const double t = from + side * reach * i / kPoints;
      if (t < 0 || t > 1) break;
      const EdgePoint point = pointOf(edge, t, near, pixels);
      if (point.pixels > radius || (best && point.pixels >= best->pixels)) break;
      if (!seen.has(edge.facet, point.at)) {
        hidden = t;
        continue;
      }
      double visible = t;
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = (hidden + visible) / 2;
        const bool isSeen = seen.has(edge.facet, pointOf(edge, middle, near, pixels).at);
        (isSeen ? visible : hidden) = middle;
      }
      best = pointOf(edge, visible, near, pixels);
      break;
    }
  }
  return best;
}

std::vector<EdgeNear> edgesNear(const std::vector<EdgeInView>& edges, const Neighbourhood& near,
                                Vec2 pixels, double radius) {
  const PaneMap& map = near.map();
  const Vec2 view = map.toView(pixels);
  const double reach = radius / map.pixelsPerMm;
  std::vector<EdgeNear> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Box box = boundsOf(edges[i].seen.arc);
    if (!areNear(box, {view, view}, reach)) continue;
    const Nearest nearest = nearestOn(edges[i].seen.arc, view);
    if (nearest.distance > reach) continue;
    out.push_back({i, pointOf(edges[i], nearest.t, near, pixels)});
  }
  std::stable_sort(out.begin(), out.end(), [](const EdgeNear& a, const EdgeNear& b) {
    return a.nearest.pixels < b.nearest.pixels;
  });
  return out;
}

}  // namespace kiri
