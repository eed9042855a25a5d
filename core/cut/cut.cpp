// SPDX-License-Identifier: MIT
#include "core/cut/cut.h"

#include <algorithm>
#include <optional>

#include "core/base/text.h"
#include "core/cut/edge_stretch.h"
#include "core/cut/rests.h"
#include "core/layers/divide_layers.h"
#include "core/paper/inscribe.h"

namespace kiri {
namespace {

std::vector<Arc> mapped(const std::vector<Arc>& chain, const Rigid& from, const Rigid& to) {
  const auto map = [&](Vec2 p) { return to.pullBack(from.apply(p)); };
  std::vector<Arc> result = chain;
  for (Arc& arc : result) {
    arc.start = map(arc.start);
    arc.end = map(arc.end);
    if (!arc.isCurved) continue;
    arc.control1 = map(arc.control1);
    arc.control2 = map(arc.control2);
  }
  return result;
}

/// A place where the chain crosses itself, if there is one.
std::optional<Vec2> selfCrossing(const std::vector<Arc>& chain, const Tolerance& tolerance) {
  std::vector<Arc> halves;  // one cubic may cross itself, half a cubic of a spline does not
  for (const Arc& arc : chain) {
    halves.push_back(part(arc, 0, 0.5));
    halves.push_back(part(arc, 0.5, 1));
  }
  const bool isClosed = distance(chain.front().start, chain.back().end) <= tolerance.length();
  for (std::size_t i = 0; i < halves.size(); ++i) {
    for (std::size_t j = i + 1; j < halves.size(); ++j) {
      const bool areNeighbours = j == i + 1;
      const bool closes = isClosed && i == 0 && j + 1 == halves.size();
      for (const Meeting& m : meetings(halves[i], halves[j], tolerance)) {
        const Vec2 p = pointAt(halves[i], m.t);
        const bool isJoint = (areNeighbours && distance(p, halves[i].end) <= tolerance.pick()) ||
                             (closes && distance(p, halves[i].start) <= tolerance.pick());
        if (!isJoint) return p;
      }
    }
  }
  return std::nullopt;
}

/// On which sides of the cut a facet hangs.
struct Sides {
  bool isLeft = false;
  bool isRight = false;
};

class Cutting {
 public:
  Cutting(const FoldedState& state, const CutRequest& request) : state_(state), request_(request) {}

  Result<FoldedState> run() {
    if (const auto p = selfCrossing(request_.chain, state_.tolerance())) {
      return Error{
          ErrorCode::CurveCrossesItself,
          "the cutting curve crosses itself at " + text(*p) + " mm; move its control points apart",
          {{*p}, {}, {}}};
    }
    if (const Status done = divide(); !done) return done.error();
    const bool keepsAll = request_.keepSides.empty() && request_.keepPieces.empty();
    renewRests(state_);
    if (keepsAll) return std::move(state_);
    std::vector<bool> keep(state_.pattern.facets.size(), false);
    if (const Status done = keepPieces(keep); !done) return done.error();
    if (const Status done = keepSides(keep); !done) return done.error();
    if (std::find(keep.begin(), keep.end(), true) == keep.end()) {
      return Error{ErrorCode::NothingLeft,
                   "the cut would throw all paper away; name a place that is to stay",
                   {}};
    }
    return keepOnly(state_, keep);
  }

 private:
  Status divide() {
    partHingesAlong();
    const std::size_t oldEdges = state_.pattern.edges.size();
    const Rigid frame = state_.poseOf(request_.frame);
    const Result<std::size_t> count =
        divideLayers(state_, request_.layers, [&](CreasePattern& p, FacetId f) {
          const std::vector<Arc> chain = mapped(request_.chain, frame, state_.poses[f.index]);
          return Result<std::vector<NewEdge>>(inscribe(p, f, chain, EdgeKind::Cut));
        });
    if (!count) return count.error();
    for (std::size_t e = oldEdges; e < state_.pattern.edges.size(); ++e) {
      // Halves of older cuts that this one crosses are new edges too; they do not lie on the chain.
      if (state_.pattern.edges[e].kind == EdgeKind::Cut && nearestOnChain(EdgeId(e)).has_value()) {
        cuts_.push_back(EdgeId(e));
      }
    }
    if (cuts_.empty()) return missed();
    return std::monostate{};
  }

  /// Where the cut runs along a crease, the crease itself is what is parted.
  void partHingesAlong() {
    std::vector<bool> isLayer(state_.pattern.facets.size(), false);
    for (const FacetId f : request_.layers) isLayer[f.index] = true;
    const Rigid frame = state_.poseOf(request_.frame);
    const std::size_t count = state_.pattern.edges.size();
    for (const Arc& arc : request_.chain) {
      if (arc.isCurved) continue;
      for (std::size_t e = 0; e < count; ++e) {
        const Edge& edge = state_.pattern.edges[e];
        const bool isJoint = edge.kind == EdgeKind::Hinge || edge.kind == EdgeKind::Tear;
        if (!isJoint || !isLayer[edge.left.index] || !isLayer[edge.right.index]) continue;
        const Rigid& pose = state_.poseOf(edge.left);
        const EdgeEnds ends{pose.apply(state_.pattern[edge.from]),
                            pose.apply(state_.pattern[edge.to])};
        const auto stretch = stretchAlong(EdgeId(e), ends, frame.apply(arc.start),
                                          frame.apply(arc.end), state_.tolerance());
        if (!stretch) continue;
        const EdgeId parted = isolate(state_.pattern, *stretch);
        state_.pattern[parted].kind = EdgeKind::Cut;
        state_.pattern[parted].angle = 0;
        cuts_.push_back(parted);
      }
    }
  }

  Error missed() const {
    return {ErrorCode::MissesPaper,
            "the cut from " + text(request_.chain.front().start) + " to " +
                text(request_.chain.back().end) +
                " mm crosses none of the chosen layers; draw it across the paper",
            {{request_.chain.front().start, request_.chain.back().end}, {}, {}}};
  }

  Status keepPieces(std::vector<bool>& keep) const {
    const std::vector<std::uint32_t> piece = piecesOf(state_.pattern);
    for (const Vec2 p : request_.keepPieces) {
      const std::optional<FacetId> facet = facetAt(state_.pattern, p);
      if (!facet) return noPaper(p);
      for (std::size_t f = 0; f < keep.size(); ++f) {
        if (piece[f] == piece[facet->index]) keep[f] = true;
      }
    }
    return std::monostate{};
  }

  static Error noPaper(Vec2 p) {
    return {ErrorCode::NotFound,
            "there is no paper at " + text(p) +
                " mm, which the cut is to keep; name a place on the paper",
            {{p}, {}, {}}};
  }

  /// True when the facet lies in the plane of the frame with its other side up.
  bool isTurned(FacetId facet) const { return dot(normalOf(facet), normalOf(request_.frame)) < 0; }
  Vec3 normalOf(FacetId facet) const { return state_.poseOf(facet).normal(); }

  /// Sides by the cut itself, then by what hangs on what.
  std::vector<Sides> label() const {
    std::vector<Sides> sides(state_.pattern.facets.size());
    std::vector<FacetId> queue;
    for (const EdgeId id : cuts_) {
      const Edge& edge = state_.pattern[id];
      const bool sameWay = runsWithChain(id);
      for (const FacetId f : {edge.left, edge.right}) {
        const bool isLeftOnPaper = f == edge.left;
        const bool isLeft = (isLeftOnPaper == sameWay) != isTurned(f);
        (isLeft ? sides[f.index].isLeft : sides[f.index].isRight) = true;
        queue.push_back(f);
      }
      if (edge.left == edge.right) sides[edge.left.index] = {true, true};
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const EdgeUse use : state_.pattern[queue[i]].border) {
        const Edge& edge = state_.pattern[use.edge];
        if (edge.kind != EdgeKind::Hinge) continue;
        Sides& next = sides[across(edge, queue[i]).index];
        const Sides here = sides[queue[i].index];
        const bool isNews = (here.isLeft && !next.isLeft) || (here.isRight && !next.isRight);
        next.isLeft = next.isLeft || here.isLeft;
        next.isRight = next.isRight || here.isRight;
        if (isNews) queue.push_back(across(edge, queue[i]));
      }
    }
    return sides;
  }

  /// Where on the chain the middle of an edge lies: the arc and the parameter; none when it lies
  /// elsewhere.
  std::optional<std::pair<std::size_t, double>> nearestOnChain(EdgeId id) const {
    const Vec2 middle = toFrame(state_.pattern[id].left, pointAt(arcOf(state_.pattern, id), 0.5));
    for (std::size_t a = 0; a < request_.chain.size(); ++a) {
      const Nearest nearest = nearestOn(request_.chain[a], middle);
      if (nearest.distance <= state_.tolerance().match()) return std::make_pair(a, nearest.t);
    }
    return std::nullopt;
  }

  /// A point of a facet, in the coordinates of the chain.
  Vec2 toFrame(FacetId facet, Vec2 paper) const {
    return state_.poseOf(request_.frame).pullBack(state_.poseOf(facet).apply(paper));
  }

  bool runsWithChain(EdgeId id) const {
    const auto place = nearestOnChain(id);
    KIRI_CHECK(place.has_value(), "a cut edge lies on the cut");
    const Arc arc = arcOf(state_.pattern, id);
    const FacetId left = state_.pattern[id].left;
    constexpr double kBefore = 7.0 / 16;
    constexpr double kBehind = 9.0 / 16;
    const Vec2 along = toFrame(left, pointAt(arc, kBehind)) - toFrame(left, pointAt(arc, kBefore));
    return dot(along, tangentAt(request_.chain[place->first], place->second)) > 0;
  }

  Status keepSides(std::vector<bool>& keep) const {
    if (request_.keepSides.empty()) return std::monostate{};
    const std::vector<Sides> sides = label();
    for (std::size_t f = 0; f < sides.size(); ++f) {
      if (sides[f].isLeft && sides[f].isRight) return joined(FacetId(f));
    }
    Sides kept;
    for (const Vec2 place : request_.keepSides) {
      bool isOnPaper = false;
      for (const FacetId f : facetsUnder(place)) {
        isOnPaper = true;
        kept.isLeft = kept.isLeft || sides[f.index].isLeft;
        kept.isRight = kept.isRight || sides[f.index].isRight;
      }
      if (!isOnPaper) return noPaper(place);
    }
    for (std::size_t f = 0; f < sides.size(); ++f) {
      const bool isUntouched = !sides[f].isLeft && !sides[f].isRight;
      if (isUntouched || (sides[f].isLeft && kept.isLeft) || (sides[f].isRight && kept.isRight))
        keep[f] = true;
    }
    return std::monostate{};
  }

  std::vector<FacetId> facetsUnder(Vec2 place) const {
    std::vector<FacetId> found;
    const Vec3 p = state_.poseOf(request_.frame).apply(place);
    for (const FacetId f : state_.layers.sets()[state_.layers.setOf(request_.frame)].upward) {
      const Vec2 here = state_.poseOf(f).pullBack(p);
      if (locate(regionOf(state_.pattern, f), here, state_.tolerance().length()) != Where::Outside)
        found.push_back(f);
    }
    return found;
  }

  Error joined(FacetId facet) const {
    const Vec2 p = interiorPointOf(state_.pattern, facet);
    return {ErrorCode::DoesNotSeparate,
            "the cut does not part the paper: both of its sides are still joined by the facet at " +
                text(p) +
                " mm on the sheet; draw the cut right across and through all layers that are to "
                "go, or keep all",
            {{p}, {}, {p}}};
  }

  FoldedState state_;
  const CutRequest& request_;
  std::vector<EdgeId> cuts_;  ///< the edges that this cut made or parted
};

}  // namespace

Result<FoldedState> cut(const FoldedState& state, const CutRequest& request) {
  return Cutting(state, request).run();
}

}  // namespace kiri
