// Paper, vertices and edges under the pointer.
// SPDX-License-Identifier: MIT
#include "editor/view/picking.h"

#include <algorithm>
#include <cmath>

#include "editor/view/edges_near.h"
#include "editor/view/neighbourhood.h"
#include "editor/view/seen_places.h"

namespace kiri {
namespace {

/// Pixels within which things lie on each other, as a hand sees it.
constexpr double kSamePlaceInPixels = 0.5;

/// True when `a` is to be preferred to `b`, of facets whose things appear at one place.
bool isBetter(const Neighbourhood& near, const std::optional<PaperPick>& underPointer, FacetId a,
              FacetId b, Vec2 pixels) {
  if (a == b) return false;
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

}  // namespace

std::optional<PaperPick> pickPaper(const FoldedState& state, const PaneMap& map, Vec2 pixels) {
  return Neighbourhood(state, map, pixels, 0).top(pixels);
}

std::vector<PaperPick> pickStack(const FoldedState& state, const PaneMap& map, Vec2 pixels) {
  return Neighbourhood(state, map, pixels, 0).stack(pixels);
}

std::optional<VertexPick> pickVertex(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                     double radius) {
  const Neighbourhood near(state, map, pixels, radius);
  const std::optional<PaperPick> paper = near.top(pixels);
  SeenPlaces seen(near);
  std::optional<VertexInView> best;
  double limit = HUGE_VAL;
  for (const VertexInView& found : verticesNear(near, pixels, radius)) {
    if (found.pixels > limit) break;
    if (best && distance(found.at, best->at) > kSamePlaceInPixels) continue;
    if (best && !isBetter(near, paper, found.facet, best->facet, found.at)) continue;
    if (!seen.has(found.facet, found.at)) continue;
    if (!best) limit = found.pixels + kSamePlaceInPixels;
    best = found;
  }
  if (!best) return std::nullopt;
  return VertexPick{best->vertex, {best->facet, state.pattern[best->vertex]}, best->pixels};
}

std::optional<EdgePick> pickEdge(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                 double radius) {
  const Neighbourhood near(state, map, pixels, radius);
  const std::optional<PaperPick> paper = near.top(pixels);
  SeenPlaces seen(near);
  EdgesNear edges(near, seen, pixels, radius);
  struct Found {
    const EdgeInView* edge = nullptr;
    EdgePoint point;
  };
  std::optional<Found> best;
  const auto offer = [&](const EdgeInView& edge, const EdgePoint& point) {
    const double nearer = best ? best->point.pixels - point.pixels : HUGE_VAL;
    if (nearer < -kSamePlaceInPixels) return;
    const bool isTie = nearer <= kSamePlaceInPixels;
    if (isTie && !isBetter(near, paper, edge.facet, best->edge->facet, point.at)) return;
    best = Found{&edge, point};
  };
  std::vector<const EdgeInView*> hidden;
  for (const EdgeInView& edge : edges.all()) {
    if (best && edge.nearest.pixels > best->point.pixels + kSamePlaceInPixels) break;
    if (edges.isSeen(edge)) {
      offer(edge, edge.nearest);
    } else {
      hidden.push_back(&edge);
    }
  }
  for (const EdgeInView* edge : hidden) {  // some come out from under other paper nearby
    if (best && edge->nearest.pixels > best->point.pixels - kSamePlaceInPixels) break;
    if (const auto point = edges.fromUnder(*edge)) offer(*edge, *point);
  }
  if (!best) return std::nullopt;
  return EdgePick{best->edge->use.edge, {best->edge->facet, best->point.paper}, best->point.pixels};
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
