// Which of the things around a pixel is meant.
// SPDX-License-Identifier: MIT
#include "editor/snap/snap.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "editor/snap/catches.h"
#include "editor/snap/snap_dragged.h"

namespace kiri {
namespace {

/// True when the borders of the paper turn at a vertex.
bool isCorner(const CreasePattern& pattern, VertexId vertex) {
  std::vector<Vec2> out;
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    if (edge.kind == EdgeKind::Hinge || (edge.from != vertex && edge.to != vertex)) continue;
    const Arc arc = arcOf(pattern, EdgeId(e));
    out.push_back(startDirection(edge.from == vertex ? arc : reversed(arc)));
  }
  return !out.empty() && (out.size() != 2 || std::abs(cross(out[0], out[1])) > kParallel);
}

Phrase labelOf(const CreasePattern& pattern, const Catch& found) {
  switch (found.kind) {
    case SnapKind::None:
      return {};
    case SnapKind::Vertex:
      if (isCorner(pattern, found.vertex)) return {KIRI_TEXT("editor/snap", "corner"), {}};
      return {KIRI_TEXT("editor/snap", "vertex"), {}};
    case SnapKind::Midpoint:
      return {KIRI_TEXT("editor/snap", "middle"), {}};
    case SnapKind::Division:
      return {KIRI_TEXT("editor/snap", "%1/%2"),
              {std::to_string(found.part), std::to_string(found.of)}};
    case SnapKind::Crossing:
      if (!found.degrees) return {KIRI_TEXT("editor/snap", "crossing"), {}};
      break;
    case SnapKind::Grid:
      return {KIRI_TEXT("editor/snap", "grid"), {}};
    case SnapKind::Angle:
      break;
    case SnapKind::Edge:
      switch (pattern[found.edge->edge].kind) {
        case EdgeKind::Border:
          return {KIRI_TEXT("editor/snap", "edge"), {}};
        case EdgeKind::Hinge:
          return {KIRI_TEXT("editor/snap", "crease"), {}};
        case EdgeKind::Tear:
          return {KIRI_TEXT("editor/snap", "tear"), {}};
        case EdgeKind::Cut:
          return {KIRI_TEXT("editor/snap", "cut"), {}};
      }
  }
  constexpr double kHalfTurn = 180;  // a line has no beginning
  double degrees = std::fmod(found.degrees.value_or(0), kHalfTurn);
  if (degrees < 0) degrees += kHalfTurn;
  return {KIRI_TEXT("editor/snap", "%1°"), {text(degrees)}};
}

PathMark pathOf(const FoldedState& state, FacetId facet, EdgeUse use) {
  PathMark path;
  path.role = MarkRole::Snap;
  const Arc arc = arcOf(state.pattern, use);
  for (const double t : flatteningParameters(arc, state.tolerance().thin())) {
    path.places.push_back(Spot{facet, pointAt(arc, t)});
  }
  return path;
}

Marks marksOf(const FoldedState& state, const Catch& found, const SnapQuestion& question,
              const Phrase& label) {
  Marks marks;
  if (found.edge) marks.push_back(pathOf(state, found.spot.facet, *found.edge));
  if (found.across) marks.push_back(pathOf(state, found.across->facet, found.across->use));
  if (found.degrees && question.direction) {
    const Spot start{question.free.facet, question.direction->from};
    marks.push_back(PathMark{MarkRole::Snap, {start, found.spot}});
  }
  marks.push_back(PointMark{MarkRole::Snap, found.spot});
  marks.push_back(TextMark{MarkRole::Snap, found.spot, label});
  return marks;
}

/// A vertex of the frame's own that lies at the point, to the last bit.
Vec2 exactIn(const FoldedState& state, FacetId frame, Vec2 point) {
  for (const EdgeUse use : state.pattern[frame].border) {
    const Vec2 vertex = state.pattern[startOf(state.pattern, use)];
    if (distance(vertex, point) <= state.tolerance().match()) return vertex;
  }
  return point;
}

/// Chooses among catches.
class Choice {
 public:
  Choice(const Neighbourhood& near, SeenPlaces& seen, const SnapQuestion& question)
      : near_(near), seen_(seen), question_(question) {
    if (const auto paper = near.top(question.pixels)) underPointer_ = paper->spot.facet;
  }

  std::optional<Catch> best(const std::vector<Catch>& sorted) {
    constexpr double kSamePlace = 0.5;  // pixels
    std::optional<Catch> best;
    for (const Catch& found : sorted) {
      if (best && found.score() > best->score() + kSamePlace) break;
      if (best && (found.kind != best->kind || distance(found.at, best->at) > kSamePlace)) continue;
      if (best && !isBetter(found, *best)) continue;
      if (isSeen(found)) best = found;
    }
    return best;
  }

 private:
  bool isSeen(const Catch& found) {
    return seen_.has(found.spot.facet, found.at) &&
           (!found.across || seen_.has(found.across->facet, found.at));
  }

  /// Of things at one place: that of the frame, of the paper under the pointer, of the uppermost.
  bool isBetter(const Catch& a, const Catch& b) const {
    for (const std::optional<FacetId> facet : {question_.frame, underPointer_}) {
      const bool hasA = facet == a.spot.facet;
      if (hasA != (facet == b.spot.facet)) return hasA;
    }
    return near_.isOver(a.spot.facet, b.spot.facet, a.at);
  }

  const Neighbourhood& near_;
  SeenPlaces& seen_;
  const SnapQuestion& question_;
  std::optional<FacetId> underPointer_;
};

/// The point without any snap.
std::optional<Spot> freeSpot(const Neighbourhood& near, Vec2 pixels, std::optional<FacetId> frame) {
  if (!frame) {
    const std::optional<PaperPick> paper = near.top(pixels);
    if (!paper) return std::nullopt;
    return paper->spot;
  }
  const std::optional<Vec2> point = near.map().onPlaneOf(near.state(), *frame, pixels);
  if (!point) return std::nullopt;
  return Spot{*frame, *point};
}

/// `meetingStep`: degrees; without angle steps, directions that count where they meet an edge, and
/// nowhere else. 0: none.
std::optional<Snapped> snap(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                            const SnapSettings& settings, std::optional<FacetId> frame,
                            std::optional<Vec2> from, double meetingStep) {
  const Neighbourhood near(state, map, pixels, settings.isOn ? settings.radius : 0);
  const std::optional<Spot> free = freeSpot(near, pixels, frame);
  if (frame && !free) return std::nullopt;
  const auto unsnapped = [&]() -> std::optional<Snapped> {
    if (!free) return std::nullopt;
    return Snapped{*free, SnapKind::None, {}, {}};
  };
  if (!settings.isOn) return unsnapped();

  SnapQuestion question{pixels, settings, frame, free.value_or(Spot{}), std::nullopt, true};
  question.catchesDirection = settings.angleStep > 0;
  const double step = question.catchesDirection ? settings.angleStep : meetingStep;
  if (frame && from) question.direction = stepDirection(near, *free, *from, step);
  SeenPlaces seen(near);
  std::optional<Catch> best =
      Choice(near, seen, question).best(catchesOnPaper(near, seen, question));
  if (free) {
    const std::vector<Catch> inPlane = catchesInPlane(near, question);
    if (!inPlane.empty() && (!best || inPlane.front().score() < best->score())) {
      best = inPlane.front();
    }
  }
  if (!best) return unsnapped();

  Snapped out;
  out.kind = best->kind;
  out.label = labelOf(state.pattern, *best);
  out.marks = marksOf(state, *best, question, out.label);
  out.spot = best->spot;
  if (frame) out.spot = {*frame, inFrame(near, best->spot, *frame)};
  if (frame && best->kind == SnapKind::Vertex) {
    out.spot.paper = exactIn(state, *frame, out.spot.paper);
  }
  return out;
}

}  // namespace

std::optional<Snapped> snapPoint(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                 const SnapSettings& settings, std::optional<FacetId> frame,
                                 std::optional<Vec2> from) {
  return snap(state, map, pixels, settings, frame, from, 0);
}

std::optional<Snapped> snapDragged(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                   const SnapSettings& settings, FacetId frame, Vec2 from) {
  return snap(state, map, pixels, settings, frame, from, kFolderStep);
}

}  // namespace kiri
