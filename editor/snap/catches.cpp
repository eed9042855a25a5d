// Vertices, middles, divisions, crossings and edges around a pixel.
// SPDX-License-Identifier: MIT
#include "editor/snap/catches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kiri {
namespace {

/// Handicaps, as parts of the radius: a point is meant when it is about as near as an edge.
constexpr double kOfCrossing = 0.1;
constexpr double kOfMiddle = 0.15;
constexpr double kOfDivision = 0.25;
constexpr double kOfEdge = 0.5;

/// Collects what lies within the radius.
class Collector {
 public:
  Collector(const Neighbourhood& near, SeenPlaces& seen, const SnapQuestion& question)
      : near_(near),
        seen_(seen),
        question_(question),
        radius_(question.settings.radius),
        pattern_(near.state().pattern) {}

  std::vector<Catch> all() {
    const SnapSettings& settings = question_.settings;
    for (const FacetId facet : near_.facets()) {
      if (!isInPlane(near_, question_, facet)) continue;
      for (const EdgeUse use : pattern_[facet].border) {
        if (settings.toVertices) addVertex(facet, use);
        if (settings.toMidpoints) addPart(facet, use, 1, 2);
        for (int i = 1; i < settings.divisions; ++i) addPart(facet, use, i, settings.divisions);
      }
    }
    if (settings.toEdges || settings.toCrossings) addEdges();
    std::stable_sort(out_.begin(), out_.end(),
                     [](const Catch& a, const Catch& b) { return a.score() < b.score(); });
    return std::move(out_);
  }

 private:
  /// Gives the catch its pixels, and keeps it when it is near enough.
  void add(Catch found, double handicap) {
    found.at = near_.map().toPixels(near_.state(), found.spot);
    found.pixels = distance(found.at, question_.pixels);
    found.handicap = handicap * radius_;
    if (found.pixels <= radius_) out_.push_back(found);
  }

  void addVertex(FacetId facet, EdgeUse use) {
    Catch found;
    found.kind = SnapKind::Vertex;
    found.vertex = startOf(pattern_, use);
    found.spot = {facet, pattern_[found.vertex]};
    add(found, 0);
  }

  /// A point that divides a straight edge, counted in the edge's own direction.
  void addPart(FacetId facet, EdgeUse use, int part, int of) {
    const Edge& edge = pattern_[use.edge];
    const int common = std::gcd(part, of);
    if (edge.isCurved() ||
        (common > 1 && of != 2 && question_.settings.toMidpoints && of / common == 2)) {
      return;  // a middle is called one
    }
    Catch found;
    found.kind = of == 2 ? SnapKind::Midpoint : SnapKind::Division;
    found.edge = use;
    found.part = part / common;
    found.of = of / common;
    found.spot = {facet, lerp(pattern_[edge.from], pattern_[edge.to],
                              static_cast<double>(part) / static_cast<double>(of))};
    add(found, of == 2 ? kOfMiddle : kOfDivision);
  }

  void addEdges() {
    EdgesNear edges(near_, seen_, question_.pixels, radius_);
    std::vector<EdgeInView> seen;
    for (const EdgeInView& edge : edges.all()) {
      if (!isInPlane(near_, question_, edge.facet)) continue;
      const bool isSeen = edges.isSeen(edge);
      const std::optional<EdgePoint> point =
          isSeen ? std::optional{edge.nearest} : edges.fromUnder(edge);
      if (!point) continue;
      seen.push_back(edge);
      if (question_.settings.toEdges) addEdgePoint(edge, point->paper);
    }
    if (question_.settings.toCrossings) addCrossings(seen);
    if (question_.settings.toEdges && question_.direction) {
      for (const EdgeInView& edge : seen) addOnDirection(edge);
    }
  }

  void addEdgePoint(const EdgeInView& edge, Vec2 paper) {
    Catch found;
    found.kind = SnapKind::Edge;
    found.edge = edge.use;
    found.spot = {edge.facet, paper};
    add(found, kOfEdge);
  }

  /// Where edges of different facets of one plane cross. (Those of one facet meet at vertices.)
  void addCrossings(const std::vector<EdgeInView>& edges) {
    if (near_.map().pane == Pane::Sheet) return;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t k = i + 1; k < edges.size(); ++k) addCrossings(edges[i], edges[k]);
    }
  }

  void addCrossings(const EdgeInView& a, const EdgeInView& b) {
    const FoldedState& state = near_.state();
    if (a.facet == b.facet || !state.layers.areCoplanar(a.facet, b.facet)) return;
    const Arc arc = arcOf(pattern_, a.use);
    const Arc other = carried(arcOf(pattern_, b.use), b.facet, a.facet);
    if (!areNear(boundsOf(arc), boundsOf(other), state.tolerance().match())) return;
    for (const Meeting& meeting : meetings(arc, other, state.tolerance())) {
      Catch found;
      found.kind = SnapKind::Crossing;
      found.edge = a.use;
      found.across = b;
      found.spot = {a.facet, pointAt(arc, meeting.t)};
      add(found, kOfCrossing);
    }
  }

  Arc carried(const Arc& arc, FacetId from, FacetId to) const {
    const auto point = [&](Vec2 p) { return inFrame(near_, {from, p}, to); };
    if (!arc.isCurved) return Arc::line(point(arc.start), point(arc.end));
    return Arc::cubic(point(arc.start), point(arc.control1), point(arc.control2), point(arc.end));
  }

  /// Where the edge meets the direction of the line that is being drawn.
  void addOnDirection(const EdgeInView& edge) {
    const StepDirection& line = *question_.direction;
    const Arc arc = carried(arcOf(pattern_, edge.use), edge.facet, question_.free.facet);
    for (const double t : lineMeetings(arc, line.from, line.along, near_.state().tolerance())) {
      if (dot(pointAt(arc, t) - line.from, line.along) <= near_.state().tolerance().pick())
        continue;
      Catch found;
      found.kind = SnapKind::Crossing;
      found.edge = edge.use;
      found.degrees = line.degrees;
      found.spot = {edge.facet, pointAt(arcOf(pattern_, edge.use), t)};
      add(found, kOfDivision);
    }
  }

  const Neighbourhood& near_;
  SeenPlaces& seen_;
  const SnapQuestion& question_;
  double radius_;
  const CreasePattern& pattern_;
  std::vector<Catch> out_;
};

}  // namespace

bool isInPlane(const Neighbourhood& near, const SnapQuestion& question, FacetId facet) {
  if (!question.frame || near.map().pane == Pane::Sheet) return true;
  return near.state().layers.areCoplanar(facet, *question.frame);
}

Vec2 inFrame(const Neighbourhood& near, const Spot& spot, FacetId frame) {
  if (spot.facet == frame || near.map().pane == Pane::Sheet) return spot.paper;
  const FoldedState& state = near.state();
  return state.poseOf(frame).pullBack(state.poseOf(spot.facet).apply(spot.paper));
}

std::vector<Catch> catchesOnPaper(const Neighbourhood& near, SeenPlaces& seen,
                                  const SnapQuestion& question) {
  return Collector(near, seen, question).all();
}

}  // namespace kiri
