// What lies around a pixel.
// SPDX-License-Identifier: MIT
#include "editor/view/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rigid.h"
#include "render/visibility/facet_view.h"
#include "render/visibility/grid.h"

namespace kiri {
namespace {

/// Calls `visit` with points whose hull holds the border of a facet.
template <class Visit>
void forHull(const CreasePattern& pattern, FacetId facet, const Visit& visit) {
  for (const EdgeUse use : pattern[facet].border) {
    const Edge& edge = pattern[use.edge];
    visit(pattern[use.isReversed ? edge.to : edge.from]);
    if (!edge.isCurved()) continue;
    visit(pattern.curves[edge.curve].control1);
    visit(pattern.curves[edge.curve].control2);
  }
}

void widen(Box& box, Vec2 p) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
}

bool holds(const Box& box, Vec2 p, double margin) {
  return p.x >= box.low.x - margin && p.x <= box.high.x + margin && p.y >= box.low.y - margin &&
         p.y <= box.high.y + margin;
}

constexpr Box kNoBox{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};

}  // namespace

Neighbourhood::Neighbourhood(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                             double radius)
    : state_(state), map_(map) {
  gather(pixels, radius);
  sortLayers();
  for (const Layers& layers : sets_) {
    for (const Near& near : layers.facets) ids_.push_back(near.id);
  }
}

void Neighbourhood::gather(Vec2 pixels, double radius) {
  constexpr double kMargin = 1;  // pixels: what a question asks right beside the radius
  const Box wanted = grown({pixels, pixels}, radius + kMargin);
  const bool isSheet = map_.pane == Pane::Sheet;
  std::vector<std::uint32_t> places(isSheet ? 1 : state_.layers.sets().size(), Id<int>::kNone);
  for (std::uint32_t i = 0; i < state_.pattern.facets.size(); ++i) {
    const FacetId facet(i);
    const Rigid pose = map_.poseOf(state_, facet);
    Box paper = kNoBox;
    Box seen = kNoBox;
    bool isBehind = false;
    forHull(state_.pattern, facet, [&](Vec2 p) {
      const Vec3 place = pose.apply(p);
      widen(paper, p);
      widen(seen, map_.toPixels(place));
      if (map_.frame.isPerspective() && map_.frame.enlargement(place) <= 0) isBehind = true;
    });
    if (!areNear(seen, wanted, 0) || isBehind) continue;
    if (isEdgeOn(pose, map_.frame, state_.tolerance())) continue;
    const std::uint32_t set = isSheet ? 0 : state_.layers.setOf(facet);
    if (places[set] == Id<int>::kNone) {
      places[set] = static_cast<std::uint32_t>(sets_.size());
      const bool isFlipped =
          !isSheet && map_.frame.facing(state_.layers.sets()[set].normal, pose.origin) < 0;
      sets_.push_back({set, isFlipped, {}});
    }
    sets_[places[set]].facets.push_back({facet, paper});
  }
}

void Neighbourhood::sortLayers() {
  if (map_.pane == Pane::Sheet) return;  // no facet lies on another
  for (Layers& layers : sets_) {
    const bool isFlipped = layers.isFlipped;
    std::sort(layers.facets.begin(), layers.facets.end(), [&](const Near& a, const Near& b) {
      const std::uint32_t ra = state_.layers.rankOf(a.id);
      const std::uint32_t rb = state_.layers.rankOf(b.id);
      return isFlipped ? ra < rb : ra > rb;
    });
  }
}

std::optional<Neighbourhood::Hit> Neighbourhood::hit(const Near& facet, Vec2 pixels) const {
  const double reach = state_.tolerance().match();
  const std::optional<Vec2> paper = map_.onPlaneOf(state_, facet.id, pixels);
  if (!paper || !holds(facet.paper, *paper, reach)) return std::nullopt;
  const Where where = locate(regionOf(state_.pattern, facet.id), *paper, reach);
  if (where == Where::Outside) return std::nullopt;
  const Spot spot{facet.id, *paper};
  return Hit{{spot, map_.placeOf(state_, spot), map_.showsFront(state_, spot)},
             where == Where::Inside};
}

bool Neighbourhood::isOverInSet(const Layers& layers, FacetId a, FacetId b) const {
  if (map_.pane == Pane::Sheet) return a < b;
  return layers.isFlipped ? state_.layers.isAbove(b, a) : state_.layers.isAbove(a, b);
}

std::optional<Neighbourhood::Hit> Neighbourhood::topOf(const Layers& layers, Vec2 pixels) const {
  const bool isSheet = map_.pane == Pane::Sheet;
  const bool isList = isSheet || state_.layers.sets()[layers.set].exceptions.empty();
  std::optional<Hit> inside;
  std::vector<Hit> onBorder;
  for (const Near& facet : layers.facets) {
    const std::optional<Hit> found = hit(facet, pixels);
    if (!found) continue;
    if (isList && (found->isInside || !isSheet)) return found;
    if (!found->isInside) {
      onBorder.push_back(*found);
    } else if (!inside || isOverInSet(layers, found->pick.spot.facet, inside->pick.spot.facet)) {
      inside = found;
    }
  }
  // Facets that only meet at the pixel need not overlap each other, and then nothing says which is
  // above; with a facet that holds the pixel they do overlap.
  std::optional<Hit> best = inside;
  for (const Hit& found : onBorder) {
    if (isSheet && best) break;
    if (!best || isOverInSet(layers, found.pick.spot.facet, best->pick.spot.facet)) best = found;
  }
  return best;
}

std::optional<Neighbourhood::Hit> Neighbourhood::topHit(Vec2 pixels) const {
  std::optional<Hit> best;
  double nearest = 0;
  for (const Layers& layers : sets_) {
    const std::optional<Hit> found = topOf(layers, pixels);
    if (!found) continue;
    const double depth = map_.frame.depth(found->pick.place);
    if (best && depth <= nearest) continue;
    best = found;
    nearest = depth;
  }
  return best;
}

std::optional<PaperPick> Neighbourhood::top(Vec2 pixels) const {
  const std::optional<Hit> found = topHit(pixels);
  if (!found) return std::nullopt;
  return found->pick;
}

std::vector<PaperPick> Neighbourhood::stack(Vec2 pixels) const {
  struct Group {
    double depth;
    std::vector<PaperPick> picks;
  };
  std::vector<Group> groups;
  for (const Layers& layers : sets_) {
    std::vector<PaperPick> picks;
    for (const Near& facet : layers.facets) {
      const std::optional<Hit> found = hit(facet, pixels);
      if (!found) continue;
      // The list is right but for exceptions: each goes up past those that it is over.
      std::size_t at = picks.size();
      while (at > 0 && isOverInSet(layers, found->pick.spot.facet, picks[at - 1].spot.facet)) --at;
      picks.insert(picks.begin() + static_cast<std::ptrdiff_t>(at), found->pick);
    }
    if (picks.empty()) continue;
    if (map_.pane == Pane::Sheet) picks = {top(pixels).value()};
    groups.push_back({map_.frame.depth(picks.front().place), std::move(picks)});
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.depth > b.depth; });
  std::vector<PaperPick> out;
  for (const Group& group : groups) {
    out.insert(out.end(), group.picks.begin(), group.picks.end());
  }
  return out;
}

bool Neighbourhood::isOver(FacetId a, FacetId b, Vec2 pixels) const {
  if (a == b) return false;
  for (const Layers& layers : sets_) {
    if (map_.pane == Pane::Sheet) return isOverInSet(layers, a, b);
    if (layers.set == state_.layers.setOf(a) && layers.set == state_.layers.setOf(b)) {
      return isOverInSet(layers, a, b);
    }
  }
  const std::optional<Vec2> onA = map_.onPlaneOf(state_, a, pixels);
  const std::optional<Vec2> onB = map_.onPlaneOf(state_, b, pixels);
  if (!onA || !onB) return onA.has_value();
  const double ahead = map_.frame.depth(map_.placeOf(state_, {a, *onA})) -
                       map_.frame.depth(map_.placeOf(state_, {b, *onB}));
  return std::abs(ahead) > state_.tolerance().match() ? ahead > 0 : a < b;
}

/// Adds the directions, degrees in the view, in which edges of the facet leave the point.
void Neighbourhood::collectDirections(const Near& facet, Vec2 pixels,
                                      std::vector<double>& degrees) const {
  const double reach = state_.tolerance().match();
  const std::optional<Vec2> paper = map_.onPlaneOf(state_, facet.id, pixels);
  if (!paper || !holds(facet.paper, *paper, reach)) return;
  const Rigid pose = map_.poseOf(state_, facet.id);
  const double step = state_.tolerance().thin();
  const Vec2 here = map_.frame.project(pose.apply(*paper));
  const auto add = [&](Vec2 direction) {
    const Vec2 away = map_.frame.project(pose.apply(*paper + direction * step)) - here;
    if (length(away) > 0) degrees.push_back(angleDegrees(away.x, away.y));
  };
  for (const EdgeUse use : state_.pattern[facet.id].border) {
    const Arc arc = arcOf(state_.pattern, use);
    if (!holds(boundsOf(arc), *paper, reach)) continue;
    const Nearest nearest = nearestOn(arc, *paper);
    if (nearest.distance > reach) continue;
    const bool isAtStart = distance(arc.start, *paper) <= 2 * reach;
    const bool isAtEnd = distance(arc.end, *paper) <= 2 * reach;
    if (isAtStart) add(startDirection(arc));
    if (isAtEnd) add(startDirection(reversed(arc)));
    if (isAtStart || isAtEnd) continue;
    const Vec2 tangent = tangentAt(arc, nearest.t);
    if (!(length(tangent) > 0)) continue;
    add(normalized(tangent));
    add(-normalized(tangent));
  }
}

std::vector<FacetId> Neighbourhood::seenAround(Vec2 pixels) const {
  constexpr double kNarrow = 1.0 / 1024;  // degrees: no paper is seen between two edges there
  const std::optional<Hit> here = topHit(pixels);
  if (here && here->isInside) return {here->pick.spot.facet};
  std::vector<double> edges;
  for (const Layers& layers : sets_) {
    for (const Near& facet : layers.facets) collectDirections(facet, pixels, edges);
  }
  std::sort(edges.begin(), edges.end());
  std::vector<FacetId> seen;
  const double step = state_.tolerance().thin() * map_.pixelsPerMm;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double next = i + 1 < edges.size() ? edges[i + 1] : edges.front() + 360;
    if (next - edges[i] < kNarrow) continue;
    const CosSin towards = cosSinDegrees((edges[i] + next) / 2);
    const std::optional<PaperPick> found =
        top({pixels.x + towards.cos * step, pixels.y - towards.sin * step});
    if (!found) continue;
    if (std::find(seen.begin(), seen.end(), found->spot.facet) == seen.end()) {
      seen.push_back(found->spot.facet);
    }
  }
  return seen;
}

std::vector<EdgeInView> Neighbourhood::edges() const {
  constexpr double kPart = 0.01;  // of a pixel: how true curves in perspective need to be
  std::vector<EdgeInView> out;
  std::vector<SeenArc> parts;
  for (const FacetId facet : ids_) {
    const Rigid pose = map_.poseOf(state_, facet);
    for (const EdgeUse use : state_.pattern[facet].border) {
      parts.clear();
      appendSeen(arcOf(state_.pattern, use), pose, map_.frame, kPart / map_.pixelsPerMm, parts);
      for (const SeenArc& part : parts) out.push_back({facet, use, part});
    }
  }
  return out;
}

}  // namespace kiri
