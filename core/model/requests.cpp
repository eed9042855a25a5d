// SPDX-License-Identifier: MIT
#include "core/model/requests.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/fold/rotate.h"

namespace kiri {
namespace {

Error badAngle(double angle, const char* range) {
  return {ErrorCode::BadValue,
          "the angle " + text(angle) + " is out of range; give degrees from " + range,
          {}};
}

/// Whether a place lies left of the line, as seen from the front. Errors: BadValue - on the line;
/// NotFound.
Result<bool> isLeftOf(const FoldedState& state, const FacetLine& line, const Place& place) {
  Vec3 p;
  const Rigid& pose = state.poseOf(line.facet);
  if (place.frame == Frame::Model) {
    p = pose.apply(onPlaneOf(state, line.facet, place.point));
  } else {
    const Result<Spot> spot = locatePlace(state, place);
    if (!spot) return spot.error();
    p = state.poseOf(spot->facet).apply(place.point);
  }
  const Vec3 along = normalized(pose.direction(line.to - line.from));
  const double side = dot(cross(upOf(state, line.facet), along), p - pose.apply(line.from));
  if (std::abs(side) > state.tolerance().match()) return side > 0;
  return Error{ErrorCode::BadValue,
               "the point " + text(place.point) +
                   " mm lies on the fold line, so it does not say which side moves",
               {{place.point}, {}, {}}};
}

Result<std::monostate> chooseSide(const FoldedState& state, const MovingSide& moving,
                                  FoldRequest& request) {
  std::vector<Place> places;
  if (const Hand* hand = std::get_if<Hand>(&moving)) {
    request.leftMoves = *hand == Hand::Left;
    return std::monostate{};
  }
  if (const MovingPoint* point = std::get_if<MovingPoint>(&moving)) {
    places = {point->place};
  } else {
    places = std::get<MovingFacets>(moving).facets;
    if (places.empty()) {
      return Error{ErrorCode::BadValue, "no facet is named that is to move; name one or more", {}};
    }
    for (const Place& place : places) {
      const Result<Spot> spot = locatePlace(state, place);
      if (!spot) return spot.error();
      request.companions.push_back(spot->paper);
    }
  }
  std::optional<bool> isLeft;
  for (const Place& place : places) {
    const Result<bool> here = isLeftOf(state, request.line, place);
    if (!here) return here.error();
    if (isLeft && *isLeft != *here) {
      return Error{ErrorCode::BadValue,
                   "the facets that are to move lie on both sides of the fold line, such as at " +
                       text(place.point) + " mm; name facets on one side",
                   {{place.point}, {}, {}}};
    }
    isLeft = *here;
  }
  request.leftMoves = *isLeft;
  return std::monostate{};
}

/// Places to keep: those on the model name a side of the cut, those on the sheet a piece.
void chooseKept(const FoldedState& state, const Keep& keep, CutRequest& request) {
  for (const Place& place : keep.places) {
    if (place.frame == Frame::Paper) {
      request.keepPieces.push_back(place.point);
    } else {
      request.keepSides.push_back(request.facet ? onPlaneOf(state, *request.facet, place.point)
                                                : place.point);
    }
  }
}

/// The facet whose plane a curve lies in: the named one, or the first that is met along the curve.
Result<FacetId> frameOfCurve(const FoldedState& state, const CurveCutStep& step,
                             const std::vector<Arc>& chain) {
  if (step.facet) {
    const Result<Spot> spot = locatePlace(state, {Frame::Paper, *step.facet});
    if (!spot) return spot.error();
    return spot->facet;
  }
  for (const double t : {0.5, 0.0, 1.0, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875}) {
    for (const Arc& arc : chain) {
      if (const Result<Spot> spot = locatePlace(state, {step.frame, pointAt(arc, t)}))
        return spot->facet;
    }
  }
  return Error{ErrorCode::MissesPaper,
               "there is no paper under the cutting curve from " + text(chain.front().start) +
                   " to " + text(chain.back().end) + " mm; draw it across the paper",
               {{chain.front().start, chain.back().end}, {}, {}}};
}

Result<std::vector<Arc>> chainOf(const CurveCutStep& step) {
  const std::size_t least = step.isClosed ? 3 : 4;
  if (step.controls.size() < least) {
    return Error{
        ErrorCode::BadValue,
        "the cutting curve has " + std::to_string(step.controls.size()) + " control points; " +
            (step.isClosed ? "a closed curve needs at least 3" : "an open curve needs at least 4"),
        {}};
  }
  return step.isClosed ? closedSpline(step.controls) : openSpline(step.controls, step.ends);
}

/// Layers for a cut: a line stands for the plane, the curve itself says what is crossed.
Result<std::vector<FacetId>> layersOfCurve(const FoldedState& state, const LayerChoice& choice,
                                           FacetId frame, const std::vector<Arc>& chain) {
  const TopLayers* top = std::get_if<TopLayers>(&choice);
  if (top == nullptr)
    return locateLayers(state, choice, {frame, chain.front().start, chain.back().end});
  std::vector<FacetId> facets;
  for (const Arc& arc : chain) {
    constexpr int kChords = 16;
    for (int i = 0; i < kChords; ++i) {
      const FacetLine chord{frame, pointAt(arc, static_cast<double>(i) / kChords),
                            pointAt(arc, static_cast<double>(i + 1) / kChords)};
      Result<std::vector<FacetId>> here = locateLayers(state, choice, chord);
      if (!here) return here;
      facets.insert(facets.end(), here->begin(), here->end());
    }
  }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

/// The box of a facet as it is seen from the front.
Box shadowOf(const FoldedState& state, FacetId facet) {
  const Rigid& pose = state.poseOf(facet);
  const Vec2 first =
      flatten(pose.apply(state.pattern[startOf(state.pattern, state.pattern[facet].border[0])]));
  Box box{first, first};
  for (const EdgeUse use : state.pattern[facet].border) {
    const Arc arc = arcOf(state.pattern, use);
    const Vec2 ends[] = {arc.end, arc.isCurved ? arc.control1 : arc.end,
                         arc.isCurved ? arc.control2 : arc.end};
    for (const Vec2 p : ends) box = joined(box, {flatten(pose.apply(p)), flatten(pose.apply(p))});
  }
  return box;
}

/// A point of a path on the vertex it is meant for.
Vec2 snappedPathPoint(const FoldedState& state, bool isOnPaper, Vec2 p) {
  double nearest = state.tolerance().pick();
  Vec2 result = p;
  const auto offer = [&](Vec2 candidate) {
    const double away = distance(candidate, p);
    if (away >= nearest) return;
    nearest = away;
    result = candidate;
  };
  for (const Edge& edge : state.pattern.edges) {
    for (const VertexId v : {edge.from, edge.to}) {
      const FacetId facet = edge.left.isValid() ? edge.left : edge.right;
      offer(isOnPaper ? state.pattern[v] : flatten(state.poseOf(facet).apply(state.pattern[v])));
    }
  }
  return result;
}

/// A cut straight down through whatever paper lies under it.
Result<CutRequest> throughRequest(const FoldedState& state, Frame drawn, std::vector<Arc> chain,
                                  const Keep& keep) {
  if (drawn != Frame::Model) {
    return Error{ErrorCode::BadValue,
                 "a cut through paper in all planes is drawn on the model; give its points in the "
                 "model frame",
                 {}};
  }
  CutRequest request{Rigid{}, std::nullopt, std::move(chain), {}, {}, {}};
  Box reach = boundsOf(request.chain.front());
  for (const Arc& arc : request.chain) reach = joined(reach, boundsOf(arc));
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    if (areNear(reach, shadowOf(state, FacetId(f)), 0)) request.layers.push_back(FacetId(f));
  }
  chooseKept(state, keep, request);
  return request;
}

}  // namespace

std::string foldName(const FoldStep& step, int number) {
  return step.name.empty() ? "fold " + std::to_string(number) : step.name;
}

Result<FoldRequest> foldRequest(const FoldedState& state, const FoldStep& step, int number) {
  if (!(step.angle >= 0 && step.angle <= 180)) return badAngle(step.angle, "0 to 180");
  const auto hasName = [](const std::string& name) {
    return [name](const FoldLine& line) { return line.name == name; };
  };
  FoldRequest request;
  request.name = foldName(step, number);
  while (step.name.empty() &&
         std::any_of(state.lines.begin(), state.lines.end(), hasName(request.name))) {
    request.name = foldName(step, ++number);
  }
  for (const FoldLine& line : state.lines) {
    if (line.name != request.name) continue;
    return Error{
        ErrorCode::BadValue,
        "there is a fold line named \"" + line.name + "\" already; give this one another name",
        {}};
  }
  Result<FacetLine> line = locateLine(state, step.line);
  if (!line) return line.error();
  request.line = *line;
  Result<std::vector<FacetId>> layers = locateLayers(state, step.layers, *line);
  if (!layers) return layers.error();
  request.layers = std::move(*layers);
  if (const auto chosen = chooseSide(state, step.moving, request); !chosen) return chosen.error();
  request.isValley = step.type == FoldType::Valley;
  request.degrees = step.angle;
  return request;
}

Result<CutRequest> cutRequest(const FoldedState& state, const StraightCutStep& step) {
  if (std::holds_alternative<ThroughAll>(step.layers)) {
    const Vec2 from = snappedPathPoint(state, step.line.frame == Frame::Paper, step.line.from);
    const Vec2 to = snappedPathPoint(state, step.line.frame == Frame::Paper, step.line.to);
    return throughRequest(state, step.line.frame, {Arc::line(from, to)}, step.keep);
  }
  const Result<FacetLine> line = locateLine(state, step.line);
  if (!line) return line.error();
  Result<std::vector<FacetId>> layers = locateLayers(state, step.layers, *line);
  if (!layers) return layers.error();
  CutRequest request{state.poseOf(line->facet), line->facet, {Arc::line(line->from, line->to)},
                     std::move(*layers),        {},          {}};
  chooseKept(state, step.keep, request);
  return request;
}

Result<CutRequest> cutRequest(const FoldedState& state, const CurveCutStep& step) {
  Result<std::vector<Arc>> chain = chainOf(step);
  if (!chain) return chain.error();
  if (std::holds_alternative<ThroughAll>(step.layers))
    return throughRequest(state, step.frame, *chain, step.keep);
  const Result<FacetId> frame = frameOfCurve(state, step, *chain);
  if (!frame) return frame.error();
  CurveCutStep here = step;
  if (step.frame == Frame::Model) {
    for (Vec2& control : here.controls) control = onPlaneOf(state, *frame, control);
  }
  if (!step.isClosed && step.ends == SplineEnds::Clamped) {
    here.controls.front() = snapToVertex(state, *frame, here.controls.front());
    here.controls.back() = snapToVertex(state, *frame, here.controls.back());
  }
  chain = chainOf(here);
  Result<std::vector<FacetId>> layers = layersOfCurve(state, step.layers, *frame, *chain);
  if (!layers) return layers.error();
  CutRequest request{state.poseOf(*frame), *frame, std::move(*chain), std::move(*layers), {}, {}};
  chooseKept(state, step.keep, request);
  return request;
}

Result<std::vector<FoldLineId>> lineGroup(const FoldedState& state,
                                          const std::vector<FoldLineName>& names) {
  std::vector<FoldLineId> lines;
  if (names.empty()) {
    for (std::size_t i = 0; i < state.lines.size(); ++i) lines.push_back(FoldLineId(i));
  }
  for (const FoldLineName& name : names) {
    const Result<FoldLineId> line = locateFoldLine(state, name);
    if (!line) return line.error();
    lines.push_back(*line);
  }
  return lines;
}

Result<EdgeRequest> edgeRequest(const FoldedState& state, const DrawnPath& path,
                                const LayerChoice& layers) {
  EdgeRequest request;
  request.path.isOnPaper = path.frame == Frame::Paper;
  if (path.points.size() == 1) {
    return Error{ErrorCode::BadValue,
                 "the path has only one point, " + text(path.points[0]) + " mm; give two or more",
                 {path.points, {}, {}}};
  }
  for (const Vec2 p : path.points) {
    request.path.points.push_back(snappedPathPoint(state, request.path.isOnPaper, p));
  }
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    if (distance(request.path.points[i], request.path.points[i + 1]) > state.tolerance().pick())
      continue;
    return Error{
        ErrorCode::BadValue,
        "two points of the path are the same, " + text(path.points[i]) + " mm; leave one out",
        {{path.points[i]}, {}, {}}};
  }
  if (const TopLayers* top = std::get_if<TopLayers>(&layers)) {
    if (top->count < 1) {
      return Error{ErrorCode::BadValue,
                   "the number of top layers must be 1 or more, not " + std::to_string(top->count),
                   {}};
    }
    request.choice.top = top->count;
  } else if (const ChosenLayers* chosen = std::get_if<ChosenLayers>(&layers)) {
    Result<std::vector<FacetId>> facets = locateFacets(state, chosen->facets);
    if (!facets) return facets.error();
    request.choice.ofFacets = std::move(*facets);
  }
  request.choice.isOwnOnly = std::holds_alternative<OwnEdges>(layers);
  return request;
}

}  // namespace kiri
