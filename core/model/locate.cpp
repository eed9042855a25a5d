// SPDX-License-Identifier: MIT
#include "core/model/locate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/layers/topmost.h"
#include "core/paper/facet_bounds.h"
#include "core/paper/inscribe.h"

namespace kiri {
namespace {

/// The point of a facet's plane that the viewer of the front sees at x, y; none when the plane
/// stands upright.
std::optional<Vec3> liftedTo(const Rigid& pose, Vec2 model) {
  const Vec3 n = pose.normal();
  if (std::abs(n.z) <= kSamePlane) return std::nullopt;
  const double z =
      pose.origin.z - (n.x * (model.x - pose.origin.x) + n.y * (model.y - pose.origin.y)) / n.z;
  return Vec3{model.x, model.y, z};
}

bool isInBox(const CreasePattern& pattern, FacetId facet, Vec2 p, double margin) {
  return holds(boundsOf(pattern, pattern[facet]), p, margin);
}

/// The topmost facet that holds a model-frame place.
std::optional<Spot> topmostAt(const FoldedState& state, Vec2 model) {
  std::optional<Spot> best;
  double bestZ = 0;
  const double tol = state.tolerance().match();
  for (std::size_t i = 0; i < state.pattern.facets.size(); ++i) {
    const FacetId f(i);
    const std::optional<Vec3> p = liftedTo(state.poseOf(f), model);
    if (!p) continue;
    const Vec2 paper = state.poseOf(f).pullBack(*p);
    if (!isInBox(state.pattern, f, paper, tol)) continue;
    if (locate(regionOf(state.pattern, f), paper, state.tolerance().length()) == Where::Outside)
      continue;
    const bool isHigher = !best || p->z > bestZ + tol ||
                          (p->z > bestZ - tol && state.layers.areCoplanar(f, best->facet) &&
                           heightOf(state, f) > heightOf(state, best->facet));
    if (!isHigher) continue;
    best = Spot{f, paper};
    bestZ = p->z;
  }
  return best;
}

/// Points of a segment, the middle first, then ever finer between.
std::vector<double> probes() {
  std::vector<double> at;
  for (int parts = 2; parts <= 32; parts *= 2) {
    for (int i = 1; i < parts; i += 2) at.push_back(static_cast<double>(i) / parts);
  }
  return at;
}

Error missed(const DrawnLine& line) {
  const char* frame = line.frame == Frame::Paper ? " mm on the sheet" : " mm on the model";
  return {ErrorCode::MissesPaper,
          "there is no paper under the line from " + text(line.from) + " to " + text(line.to) +
              frame + "; draw it across the paper",
          {{line.from, line.to}, {}, {}}};
}

/// The middles of the stretches that a line has in the facets under it, for all probes of a long
/// line may pass the paper by. Those nearest to the line's own middle come first.
std::vector<double> chordMiddles(const FoldedState& state, const DrawnLine& line) {
  std::vector<double> at;
  for (std::size_t i = 0; i < state.pattern.facets.size(); ++i) {
    const FacetId f(i);
    Vec2 from = line.from;
    Vec2 to = line.to;
    if (line.frame == Frame::Model) {
      const std::optional<Vec3> a = liftedTo(state.poseOf(f), from);
      const std::optional<Vec3> b = liftedTo(state.poseOf(f), to);
      if (!a || !b) continue;
      from = state.poseOf(f).pullBack(*a);
      to = state.poseOf(f).pullBack(*b);
    }
    for (const Chord& chord : chordsOf(state.pattern, f, from, to)) {
      at.push_back((std::max(0.0, chord.t0) + std::min(1.0, chord.t1)) / 2);
    }
  }
  std::sort(at.begin(), at.end(), [](double a, double b) {
    const double awayA = std::abs(a - 0.5);
    const double awayB = std::abs(b - 0.5);
    return awayA != awayB ? awayA < awayB : a < b;
  });
  return at;
}

Result<FacetId> frameOf(const FoldedState& state, const DrawnLine& line) {
  if (line.frame == Frame::Paper && line.facet) {
    const std::optional<FacetId> facet = facetAt(state.pattern, *line.facet);
    if (facet) return *facet;
    return Error{
        ErrorCode::NotFound,
        "there is no facet at " + text(*line.facet) + " mm on the sheet, which the line names",
        {{*line.facet}, {}, {}}};
  }
  std::vector<double> at = probes();
  const std::vector<double> middles = chordMiddles(state, line);
  at.insert(at.end(), middles.begin(), middles.end());
  for (const double t : at) {
    const Vec2 p = lerp(line.from, line.to, t);
    if (line.frame == Frame::Paper) {
      if (const auto facet = facetAt(state.pattern, p)) return *facet;
    } else if (const auto spot = topmostAt(state, p)) {
      return spot->facet;
    }
  }
  return missed(line);
}

/// How far along the line, in units of it, each facet of the plane reaches; also facets that border
/// it by a flat hinge, or by any hinge.
enum class Bordering { FlatHinges, AllHinges };
std::vector<Cover> coversOf(const FoldedState& state, const FacetLine& line, Bordering bordering) {
  std::vector<Cover> covers;
  const double tol = state.tolerance().length();
  for (const FacetId f : state.layers.sets()[state.layers.setOf(line.facet)].upward) {
    const FacetLine here = lineOn(state, line, f);
    const double height = heightOf(state, f);
    for (const Chord& chord : chordsOf(state.pattern, f, here.from, here.to)) {
      covers.push_back({f.index, std::max(0.0, chord.t0), std::min(1.0, chord.t1), height});
    }
    const double span = distance(here.from, here.to);
    const Vec2 along = (here.to - here.from) / span;
    for (const EdgeUse use : state.pattern[f].border) {
      const Edge& edge = state.pattern[use.edge];
      if (edge.kind != EdgeKind::Hinge) continue;
      if (edge.angle != 0 && bordering == Bordering::FlatHinges) continue;
      const Vec2 a = state.pattern[edge.from] - here.from;
      const Vec2 b = state.pattern[edge.to] - here.from;
      if (std::abs(cross(along, a)) > 2 * tol || std::abs(cross(along, b)) > 2 * tol) continue;
      const double s = dot(along, a) / span;
      const double t = dot(along, b) / span;
      covers.push_back(
          {f.index, std::max(0.0, std::min(s, t)), std::min(1.0, std::max(s, t)), height});
    }
  }
  return covers;
}

}  // namespace

Vec2 snapToVertex(const FoldedState& state, FacetId frame, Vec2 point) {
  const Rigid& pose = state.poseOf(frame);
  double nearest = state.tolerance().pick();
  Vec2 result = point;
  for (const FacetId f : state.layers.sets()[state.layers.setOf(frame)].upward) {
    for (const EdgeUse use : state.pattern[f].border) {
      const Vec2 vertex = state.pattern[startOf(state.pattern, use)];
      const Vec2 here = f == frame ? vertex : pose.pullBack(state.poseOf(f).apply(vertex));
      const double away = distance(here, point);
      if (away >= nearest) continue;
      nearest = away;
      result = here;
    }
  }
  return result;
}

double heightOf(const FoldedState& state, FacetId facet) {
  const LayerSet& set = state.layers.sets()[state.layers.setOf(facet)];
  const double rank = state.layers.rankOf(facet);
  return set.normal.z < 0 ? static_cast<double>(set.upward.size()) - 1 - rank : rank;
}

Vec2 onPlaneOf(const FoldedState& state, FacetId frame, Vec2 model) {
  const Rigid& pose = state.poseOf(frame);
  const std::optional<Vec3> p = liftedTo(pose, model);
  return pose.pullBack(p ? *p : Vec3{model.x, model.y, 0});
}

Result<Spot> locatePlace(const FoldedState& state, const Place& place) {
  if (place.frame == Frame::Paper) {
    if (const auto facet = facetAt(state.pattern, place.point)) return Spot{*facet, place.point};
  } else if (const auto spot = topmostAt(state, place.point)) {
    return *spot;
  }
  const char* frame =
      place.frame == Frame::Paper ? " mm on the sheet" : " mm on the model as it lies";
  return Error{ErrorCode::NotFound,
               "there is no paper at " + text(place.point) + frame,
               {{place.point}, {}, {}}};
}

Result<FacetLine> locateLine(const FoldedState& state, const DrawnLine& line) {
  if (distance(line.from, line.to) <= state.tolerance().pick()) {
    return Error{ErrorCode::BadValue,
                 "the line at " + text(line.from) + " mm has no length; give two different points",
                 {{line.from}, {}, {}}};
  }
  const Result<FacetId> frame = frameOf(state, line);
  if (!frame) return frame.error();
  FacetLine result{*frame, line.from, line.to};
  if (line.frame == Frame::Model) {
    result.from = onPlaneOf(state, *frame, line.from);
    result.to = onPlaneOf(state, *frame, line.to);
  }
  result.from = snapToVertex(state, *frame, result.from);
  result.to = snapToVertex(state, *frame, result.to);
  return result;
}

Result<std::vector<FacetId>> locateFacets(const FoldedState& state,
                                          const std::vector<Place>& places) {
  std::vector<FacetId> facets;
  for (const Place& place : places) {
    const Result<Spot> spot = locatePlace(state, place);
    if (!spot) return spot.error();
    facets.push_back(spot->facet);
  }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

Result<std::vector<FacetId>> locateLayers(const FoldedState& state, const LayerChoice& choice,
                                          const FacetLine& line) {
  if (std::holds_alternative<AllLayers>(choice)) {
    return state.layers.sets()[state.layers.setOf(line.facet)].upward;
  }
  if (const TopLayers* top = std::get_if<TopLayers>(&choice)) {
    if (top->count < 1) {
      return Error{ErrorCode::BadValue,
                   "the number of top layers must be 1 or more, not " + std::to_string(top->count),
                   {}};
    }
    std::vector<FacetId> facets;
    std::vector<Cover> covers = coversOf(state, line, Bordering::FlatHinges);
    if (covers.empty()) covers = coversOf(state, line, Bordering::AllHinges);
    for (const std::size_t i : topmost(covers, top->count, kParallel)) facets.push_back(FacetId(i));
    return facets;
  }
  if (std::holds_alternative<ThroughAll>(choice)) {
    return Error{ErrorCode::BadValue,
                 "only cuts drawn on the model go through paper in all planes; choose all layers, "
                 "the top ones, or facets",
                 {}};
  }
  if (std::holds_alternative<OwnEdges>(choice)) {
    return Error{ErrorCode::BadValue,
                 "only tears and mends name edges by their path; choose all layers, the top ones, "
                 "or facets",
                 {}};
  }
  const ChosenLayers& chosen = std::get<ChosenLayers>(choice);
  Result<std::vector<FacetId>> facets = locateFacets(state, chosen.facets);
  if (!facets) return facets;
  for (std::size_t i = 0; i < facets->size(); ++i) {
    if (state.layers.areCoplanar((*facets)[i], line.facet)) continue;
    const Vec2 p = interiorPointOf(state.pattern, (*facets)[i]);
    return Error{
        ErrorCode::BadValue,
        "the chosen facet at " + text(p) + " mm on the sheet does not lie in the plane of the line",
        {{p}, {}, {p}}};
  }
  return facets;
}

Result<FoldLineId> locateFoldLine(const FoldedState& state, const FoldLineName& name) {
  if (const std::string* wanted = std::get_if<std::string>(&name)) {
    std::string known;
    for (std::size_t i = 0; i < state.lines.size(); ++i) {
      if (state.lines[i].name == *wanted) return FoldLineId(i);
      known += (known.empty() ? "" : ", ") + ("\"" + state.lines[i].name + "\"");
    }
    const std::string list = known.empty() ? "nothing has been folded yet" : "there are " + known;
    return Error{
        ErrorCode::NotFound, "there is no fold line named \"" + *wanted + "\"; " + list, {}};
  }
  const Place place = std::get<Place>(name);
  FoldLineId best;
  double nearest = state.tolerance().pick();
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge || !edge.line.isValid()) continue;
    Arc arc = arcOf(state.pattern, EdgeId(e));
    if (place.frame == Frame::Model) {
      const Rigid& pose = state.poseOf(edge.left);
      arc = Arc::line(flatten(pose.apply(arc.start)), flatten(pose.apply(arc.end)));
    }
    const double away = nearestOn(arc, place.point).distance;
    if (away >= nearest) continue;
    nearest = away;
    best = edge.line;
  }
  if (best.isValid()) return best;
  return Error{ErrorCode::NotFound,
               "no fold line runs through " + text(place.point) + " mm; name a point on its crease",
               {{place.point}, {}, {}}};
}

}  // namespace kiri
