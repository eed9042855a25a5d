// Paper, vertices and edges under the pointer.
// SPDX-License-Identifier: MIT
#include "editor/view/picking.h"

#include <algorithm>
#include <cmath>

#include "editor/view/neighbourhood.h"

namespace kiri {
namespace {

/// Pixels within which things lie on each other, as a hand sees it.
constexpr double kSamePlaceInPixels = 0.5;

/// What is seen around points of the pane; many candidates in a row lie at one point.
class Seen {
 public:
  explicit Seen(const Neighbourhood& near)
      : near_(near), same_(near.state().tolerance().match() * near.map().pixelsPerMm) {}

  bool has(FacetId facet, Vec2 pixels) {
    if (!isKnown_ || distance(pixels, at_) > same_) {
      at_ = pixels;
      facets_ = near_.seenAround(pixels);
      isKnown_ = true;
    }
    return std::find(facets_.begin(), facets_.end(), facet) != facets_.end();
  }

 private:
  const Neighbourhood& near_;
  double same_;  ///< pixels within which two points are one
  bool isKnown_ = false;
  Vec2 at_;
  std::vector<FacetId> facets_;
};

/// True when `a` is to be preferred to `b`, of facets whose things appear at one place.
bool isBetter(const Neighbourhood& near, const std::optional<PaperPick>& underPointer, FacetId a,
              FacetId b, Vec2 pixels) {
  if (underPointer && a == underPointer->spot.facet) return true;
  if (underPointer && b == underPointer->spot.facet) return false;
  return near.isOver(a, b, pixels);
}

struct VertexInView {
  VertexId vertex;
  FacetId facet;
  Vec2 at;
  double pixels = 0;
};

std::vector<VertexInView> verticesNear(const Neighbourhood& near, Vec2 pixels, double radius) {
  const FoldedState& state = near.state();
  std::vector<VertexInView> out;
  for (const FacetId facet : near.facets()) {
    for (const EdgeUse use : state.pattern[facet].border) {
      const VertexId vertex = startOf(state.pattern, use);
      const Vec2 at = near.map().toPixels(state, {facet, state.pattern[vertex]});
      const double away = distance(at, pixels);
      if (away <= radius) out.push_back({vertex, facet, at, away});
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const VertexInView& a, const VertexInView& b) {
    return a.pixels < b.pixels;
  });
  return out;
}

/// A point of an edge: exactly on the paper's own curve, wherever its picture is only near.
struct EdgePoint {
  double t = 0;  ///< on the part of the edge that is looked at
  Vec2 paper;
  Vec2 at;  ///< pixels
  double pixels = 0;
};

EdgePoint pointOf(const EdgeInView& edge, double t, const Neighbourhood& near, Vec2 pixels) {
  const Vec2 paper = pointAt(arcOf(near.state().pattern, edge.use), edge.seen.onPaper(t));
  const Vec2 at = near.map().toPixels(near.state(), {edge.facet, paper});
  return {t, paper, at, distance(at, pixels)};
}

/// The nearest point of an edge that is seen, where the nearest of all is hidden: found among
/// points along the edge, then between a hidden and a seen one.
std::optional<EdgePoint> nearestSeen(const EdgeInView& edge, const Neighbourhood& near, Seen& seen,
                                     Vec2 pixels, double radius, double from) {
  constexpr int kPoints = 24;
  constexpr int kHalvings = 16;
  const double span = lengthOf(edge.seen.arc, radius / near.map().pixelsPerMm);
  // Only so much of the edge can be within the radius, on either side of the nearest point.
  const double reach = std::min(1.0, 2 * radius / near.map().pixelsPerMm / std::max(span, 0.0));
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

struct EdgeNear {
  std::size_t number = 0;  ///< in the list of edges
  EdgePoint nearest;
};

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

}  // namespace

std::optional<PaperPick> pickPaper(const FoldedState& state, const PaneMap& map, Vec2 pixels) {
  return Neighbourhood(state, map, pixels, 0).top(pixels);
}

std::vector<PaperPick> pickStack(const FoldedState& state, const PaneMap& map, Vec2 pixels) {
  return Neighbourhood(state, map, pixels, 0).stack(pixels);
}

std::optional<VertexPick> pickVertex(const Neighbourhood& near, Vec2 pixels, double radius) {
  const std::optional<PaperPick> paper = near.top(pixels);
  Seen seen(near);
  std::optional<VertexInView> best;
  double limit = HUGE_VAL;
  for (const VertexInView& found : verticesNear(near, pixels, radius)) {
    if (found.pixels > limit) break;
    if (!seen.has(found.facet, found.at)) continue;
    if (!best) limit = found.pixels + kSamePlaceInPixels;
    if (!best || isBetter(near, paper, found.facet, best->facet, found.at)) best = found;
  }
  if (!best) return std::nullopt;
  const Vec2 place = near.state().pattern[best->vertex];
  return VertexPick{best->vertex, {best->facet, place}, best->pixels};
}

std::optional<EdgePick> pickEdge(const Neighbourhood& near, Vec2 pixels, double radius) {
  const std::optional<PaperPick> paper = near.top(pixels);
  const std::vector<EdgeInView> edges = near.edges();
  Seen seen(near);
  std::optional<EdgeNear> best;
  for (const EdgeNear& found : edgesNear(edges, near, pixels, radius)) {
    const EdgeInView& edge = edges[found.number];
    if (best && found.nearest.pixels > best->nearest.pixels + kSamePlaceInPixels) break;
    std::optional<EdgePoint> point = found.nearest;
    if (!seen.has(edge.facet, point->at)) {
      point = nearestSeen(edge, near, seen, pixels, radius, found.nearest.t);
    }
    if (!point) continue;
    if (best) {
      const double nearer = best->nearest.pixels - point->pixels;
      if (nearer < -kSamePlaceInPixels) continue;
      if (nearer <= kSamePlaceInPixels &&
          !isBetter(near, paper, edge.facet, edges[best->number].facet, point->at)) {
        continue;
      }
    }
    best = EdgeNear{found.number, *point};
  }
  if (!best) return std::nullopt;
  const EdgeInView& edge = edges[best->number];
  return EdgePick{edge.use.edge, {edge.facet, best->nearest.paper}, best->nearest.pixels};
}

std::optional<VertexPick> pickVertex(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                     double radius) {
  return pickVertex(Neighbourhood(state, map, pixels, radius), pixels, radius);
}

std::optional<EdgePick> pickEdge(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                 double radius) {
  return pickEdge(Neighbourhood(state, map, pixels, radius), pixels, radius);
}

std::vector<FacetId> facetsWithin(const FoldedState& state, const PaneMap& map, Vec2 a, Vec2 b) {
  const Box box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  std::vector<FacetId> out;
  for (std::uint32_t i = 0; i < state.pattern.facets.size(); ++i) {
    const FacetId facet(i);
    bool isWithin = true;
    for (const EdgeUse use : state.pattern[facet].border) {
      const Arc arc = arcOf(state.pattern, use);
      for (const double t : flatteningParameters(arc, state.tolerance().flattening())) {
        const Vec2 p = map.toPixels(state, {facet, pointAt(arc, t)});
        isWithin = isWithin && p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y &&
                   p.y <= box.high.y;
      }
      if (!isWithin) break;
    }
    if (isWithin) out.push_back(facet);
  }
  return out;
}

}  // namespace kiri
