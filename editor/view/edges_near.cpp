// Finding the edges around a pixel, and where they come out from under other paper.
// SPDX-License-Identifier: MIT
#include "editor/view/edges_near.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

bool contains(const std::vector<FacetId>& facets, FacetId facet) {
  return std::find(facets.begin(), facets.end(), facet) != facets.end();
}

}  // namespace

EdgesNear::EdgesNear(const Neighbourhood& near, SeenPlaces& seen, Vec2 pixels, double radius)
    : near_(near), seen_(seen), pixels_(pixels), radius_(radius) {
  constexpr double kPart = 0.01;  // of a pixel: how true curves in perspective need to be
  const PaneMap& map = near.map();
  const CreasePattern& pattern = near.state().pattern;
  std::vector<SeenArc> parts;
  for (const FacetId facet : near.facets()) {
    const Rigid pose = map.poseOf(near.state(), facet);
    for (const EdgeUse use : pattern[facet].border) {
      const Arc arc = arcOf(pattern, use);
      if (!arc.isCurved) {
        const Arc line =
            Arc::line(map.toPixels(pose.apply(arc.start)), map.toPixels(pose.apply(arc.end)));
        if (nearestOn(line, pixels).distance > radius) continue;
      }
      parts.clear();
      appendSeen(arc, pose, map.frame, kPart / map.pixelsPerMm, parts);
      for (const SeenArc& part : parts) add(facet, use, part);
    }
  }
  std::stable_sort(edges_.begin(), edges_.end(), [](const EdgeInView& a, const EdgeInView& b) {
    return a.nearest.pixels < b.nearest.pixels;
  });
}

void EdgesNear::add(FacetId facet, EdgeUse use, const SeenArc& part) {
  const Vec2 view = near_.map().toView(pixels_);
  const double reach = radius_ / near_.map().pixelsPerMm;
  if (!areNear(boundsOf(part.arc), {view, view}, reach)) return;
  const Nearest nearest = nearestOn(part.arc, view);
  if (nearest.distance > reach) return;
  EdgeInView edge{facet, use, part, {}};
  edge.nearest = pointOf(edge, nearest.t);
  edges_.push_back(edge);
}

EdgePoint EdgesNear::pointOf(const EdgeInView& edge, double t) const {
  const Vec2 paper = pointAt(arcOf(near_.state().pattern, edge.use), edge.seen.onPaper(t));
  const Vec2 at = near_.map().toPixels(near_.state(), {edge.facet, paper});
  return {t, paper, at, distance(at, pixels_)};
}

bool EdgesNear::isSeen(const EdgeInView& edge) { return seen_.has(edge.facet, edge.nearest.at); }

/// Points within the radius, on one side of the nearest point, going away from it.
std::vector<EdgePoint> EdgesNear::pointsBeside(const EdgeInView& edge, double side) const {
  constexpr int kPoints = 24;
  const double mm = radius_ / near_.map().pixelsPerMm;
  const double span = lengthOf(edge.seen.arc, mm);
  const double reach = span > 2 * mm ? 2 * mm / span : 1;  // no more of it can be within the radius
  std::vector<EdgePoint> points;
  for (int i = 1; i <= kPoints; ++i) {
    const double t = edge.nearest.t + side * reach * i / kPoints;
    if (t < 0 || t > 1) break;
    const EdgePoint point = pointOf(edge, t);
    if (point.pixels > radius_) break;
    points.push_back(point);
  }
  return points;
}

/// Edges with one key lie on each other, with their paper on the same side.
EdgesNear::Key EdgesNear::keyOf(const EdgeInView& edge) const {
  const auto from = SeenPlaces::keyOf(pointOf(edge, 0).at);
  const auto to = SeenPlaces::keyOf(pointOf(edge, 1).at);
  const bool isFront = near_.map().showsFront(near_.state(), {edge.facet, edge.nearest.paper});
  return isFront ? Key{from, to} : Key{to, from};
}

std::optional<EdgePoint> EdgesNear::fromUnder(const EdgeInView& edge) {
  constexpr int kHalvings = 10;  // to a hundredth of a pixel and less
  const Key key = keyOf(edge);
  const auto known = edge.seen.arc.isCurved ? along_.end() : along_.find(key);
  if (known != along_.end() && !contains(known->second, edge.facet)) return std::nullopt;
  std::vector<FacetId> any;
  std::optional<EdgePoint> best;
  for (const double side : {-1.0, 1.0}) {
    double hidden = edge.nearest.t;
    bool isFound = false;
    for (const EdgePoint& point : pointsBeside(edge, side)) {
      const bool isHere = seen_.has(edge.facet, point.at);
      const std::vector<FacetId>& here = seen_.knownAt(point.at);
      any.insert(any.end(), here.begin(), here.end());
      if (isFound) continue;
      if (!isHere) hidden = point.t;
      if (!isHere) continue;
      isFound = true;
      double visible = point.t;
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = (hidden + visible) / 2;
        (seen_.has(edge.facet, pointOf(edge, middle).at) ? visible : hidden) = middle;
      }
      const EdgePoint nearest = pointOf(edge, visible);
      if (!best || nearest.pixels < best->pixels) best = nearest;
    }
  }
  if (!edge.seen.arc.isCurved) along_.emplace(key, std::move(any));
  return best;
}

}  // namespace kiri
