// What lies around a pixel.
// SPDX-License-Identifier: MIT
#include "editor/view/neighbourhood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/geometry/bounds.h"
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

/// Pixels: what a question may ask right beside the radius.
constexpr double kMargin = 1;

/// The straight edges of a facet that come near a pixel, as they appear with the paper on their
/// left: facets with the same outline are the same there, as far as the radius goes. None: there
/// are curved ones.
using Outline = std::vector<std::array<double, 4>>;

std::optional<Outline> outlineNear(const FoldedState& state, const PaneMap& map, FacetId facet,
                                   Vec2 pixels, double radius) {
  constexpr double kCells = 1 << 16;  // a pixel, each way: above rounding
  const Rigid pose = map.poseOf(state, facet);
  const bool isFront = map.frame.facing(pose.normal(), pose.origin) > 0;
  Outline outline;
  for (const EdgeUse use : state.pattern[facet].border) {
    if (state.pattern[use.edge].isCurved()) return std::nullopt;
    Vec2 from = map.toPixels(pose.apply(state.pattern[startOf(state.pattern, use)]));
    Vec2 to = map.toPixels(pose.apply(state.pattern[endOf(state.pattern, use)]));
    if (nearestOn(Arc::line(from, to), pixels).distance > radius) continue;
    if (!isFront) std::swap(from, to);
    outline.push_back({std::round(from.x * kCells), std::round(from.y * kCells),
                       std::round(to.x * kCells), std::round(to.y * kCells)});
  }
  std::sort(outline.begin(), outline.end());
  return outline;
}

constexpr Box kNoBox{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};

}  // namespace

Neighbourhood::Neighbourhood(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                             double radius)
    : state_(state), map_(map) {
  gather(pixels, radius);
  sortLayers();
  for (Layers& layers : sets_) {
    leaveOutCovered(layers, pixels, radius);
    for (const Near& near : layers.open) ids_.push_back(near.id);
  }
}

void Neighbourhood::gather(Vec2 pixels, double radius) {
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
      paper = joined(paper, p);
      seen = joined(seen, map_.toPixels(place));
      if (map_.frame.isPerspective() && map_.frame.enlargement(place) <= 0) isBehind = true;
    });
    if (!areNear(seen, wanted, 0) || isBehind) continue;
    if (isEdgeOn(pose, map_.frame, state_.tolerance())) continue;
    const std::uint32_t set = isSheet ? 0 : state_.layers.setOf(facet);
    if (places[set] == Id<int>::kNone) {
      places[set] = static_cast<std::uint32_t>(sets_.size());
      const bool isFlipped =
          !isSheet && map_.frame.facing(state_.layers.sets()[set].normal, pose.origin) < 0;
      sets_.push_back({set, isFlipped, {}, {}});
    }
    sets_[places[set]].all.push_back({facet, paper});
  }
}

void Neighbourhood::sortLayers() {
  if (map_.pane == Pane::Sheet) return;  // no facet lies on another
  for (Layers& layers : sets_) {
    const bool isFlipped = layers.isFlipped;
    std::sort(layers.all.begin(), layers.all.end(), [&](const Near& a, const Near& b) {
      const std::uint32_t ra = state_.layers.rankOf(a.id);
      const std::uint32_t rb = state_.layers.rankOf(b.id);
      return isFlipped ? ra < rb : ra > rb;
    });
  }
}

void Neighbourhood::leaveOutCovered(Layers& layers, Vec2 pixels, double radius) const {
  const bool isList = map_.pane != Pane::Sheet &&
                      state_.layers.sets()[layers.set].exceptions.empty() && layers.all.size() > 1;
  if (!isList) {
    layers.open = layers.all;
    return;
  }
  std::set<Outline> known;
  for (const Near& near : layers.all) {
    auto outline = outlineNear(state_, map_, near.id, pixels, radius + kMargin);
    if (outline && outline->empty()) {
      if (!hit(near, pixels)) continue;
      layers.open.push_back(near);  // it covers all that is below it
      return;
    }
    if (outline && !known.insert(std::move(*outline)).second) continue;
    layers.open.push_back(near);
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
  for (const Near& facet : layers.open) {
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
    for (const Near& facet : layers.all) {
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

/// Facets, one of each other plane, that lie at the same depth there.
std::vector<FacetId> Neighbourhood::touchingAt(const PaperPick& place, Vec2 pixels) const {
  std::vector<FacetId> out;
  if (map_.pane == Pane::Sheet) return out;
  const double near = state_.tolerance().match();
  for (const Layers& layers : sets_) {
    if (layers.open.empty() || layers.set == state_.layers.setOf(place.spot.facet)) continue;
    const FacetId other = layers.open.front().id;
    const Rigid& pose = state_.poseOf(other);
    const double away = dot(place.place - pose.origin, pose.normal());
    if (std::abs(away) <= near && topOf(layers, pixels)) out.push_back(other);
  }
  return out;
}

bool Neighbourhood::coversAllAround(const PaperPick& top, Vec2 pixels) const {
  const Region region = regionOf(state_.pattern, top.spot.facet);
  return locate(region, top.spot.paper, state_.tolerance().match()) == Where::Inside &&
         touchingAt(top, pixels).empty();
}

void Neighbourhood::addDirections(FacetId facet, Vec2 pixels, std::vector<double>& degrees) const {
  const std::optional<Vec2> paper = map_.onPlaneOf(state_, facet, pixels);
  if (!paper) return;
  const Spot spot{facet, *paper};
  addEdgeDirections(spot, degrees);
  const PaperPick here{spot, map_.placeOf(state_, spot), true};
  for (const FacetId other : touchingAt(here, pixels)) {
    const Vec3 along = cross(state_.poseOf(facet).normal(), state_.poseOf(other).normal());
    if (!(length(along) > kSamePlane)) continue;
    addDirection(spot, normalized(along), degrees);
    addDirection(spot, -normalized(along), degrees);
  }
}

/// A direction in the pane's space, as it is seen from a place.
void Neighbourhood::addDirection(const Spot& spot, Vec3 direction,
                                 std::vector<double>& degrees) const {
  const double step = state_.tolerance().thin();
  const Vec3 place = map_.placeOf(state_, spot);
  const Vec2 away = map_.frame.project(place + direction * step) - map_.frame.project(place);
  if (!(length(away) > 0)) return;
  const double angle = angleDegrees(away.x, away.y);
  degrees.push_back(angle < 0 ? angle + 360 : angle);
}

void Neighbourhood::addEdgeDirections(const Spot& spot, std::vector<double>& degrees) const {
  const double reach = state_.tolerance().match();
  const Rigid pose = map_.poseOf(state_, spot.facet);
  const auto add = [&](Vec2 direction) { addDirection(spot, pose.direction(direction), degrees); };
  for (const EdgeUse use : state_.pattern[spot.facet].border) {
    const Arc arc = arcOf(state_.pattern, use);
    if (!holds(boundsOf(arc), spot.paper, reach)) continue;
    const Nearest nearest = nearestOn(arc, spot.paper);
    if (nearest.distance > reach) continue;
    const bool isAtStart = distance(arc.start, spot.paper) <= 2 * reach;
    const bool isAtEnd = distance(arc.end, spot.paper) <= 2 * reach;
    if (isAtStart) add(startDirection(arc));
    if (isAtEnd) add(startDirection(reversed(arc)));
    if (isAtStart || isAtEnd) continue;
    const Vec2 tangent = tangentAt(arc, nearest.t);
    if (!(length(tangent) > 0)) continue;
    add(normalized(tangent));
    add(-normalized(tangent));
  }
}

}  // namespace kiri
