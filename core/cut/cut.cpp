// SPDX-License-Identifier: MIT
#include "core/cut/cut.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/cut/edge_stretch.h"
#include "core/cut/rests.h"
#include "core/layers/divide_layers.h"
#include "core/paper/inscribe.h"

namespace kiri {
namespace {

/// Takes places in the plane of the cut to the paper frame of a facet, along the normal of that
/// plane: affine, so that curves stay exact.
class Onto {
 public:
  Onto(const Rigid& frame, const Rigid& pose)
      : isCoplanar_(length(cross(frame.normal(), pose.normal())) <= kSamePlane),
        frame_(frame),
        pose_(pose),
        x_{dot(pose.x, frame.x), dot(pose.x, frame.y)},
        y_{dot(pose.y, frame.x), dot(pose.y, frame.y)},
        origin_(frame.pullBack(pose.origin)) {}

  Vec2 operator()(Vec2 p) const {
    if (isCoplanar_) return pose_.pullBack(frame_.apply(p));
    const Vec2 d = p - origin_;
    return Vec2{cross(d, y_), cross(x_, d)} / cross(x_, y_);
  }

  Arc operator()(const Arc& arc) const {
    if (!arc.isCurved) return Arc::line((*this)(arc.start), (*this)(arc.end));
    return Arc::cubic((*this)(arc.start), (*this)(arc.control1), (*this)(arc.control2),
                      (*this)(arc.end));
  }

 private:
  bool isCoplanar_;
  const Rigid& frame_;
  const Rigid& pose_;
  Vec2 x_;
  Vec2 y_;
  Vec2 origin_;
};

std::vector<Arc> mapped(const std::vector<Arc>& chain, const Onto& onto) {
  std::vector<Arc> result;
  for (const Arc& arc : chain) result.push_back(onto(arc));
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
    if (const Status lie = checkUpright(); !lie) return lie.error();
    partHingesAlong();
    const std::size_t oldEdges = state_.pattern.edges.size();
    const Result<std::size_t> count =
        divideLayers(state_, request_.layers, [&](CreasePattern& p, FacetId f) {
          const std::vector<Arc> chain =
              mapped(request_.chain, Onto(request_.frame, state_.poses[f.index]));
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

  /// A curtain that hangs from the cut would slide along such a facet.
  Status checkUpright() const {
    for (const FacetId f : request_.layers) {
      if (std::abs(dot(normalOf(f), request_.frame.normal())) > kUpright) continue;
      const Vec2 p = interiorPointOf(state_.pattern, f);
      return Error{ErrorCode::BadValue,
                   "the facet at " + text(p) +
                       " mm on the sheet stands upright under the cut, which cannot go through it; "
                       "fold it to one side first, or choose other layers",
                   {{p}, {}, {p}}};
    }
    return std::monostate{};
  }

  /// Where the cut runs along a crease, the crease itself is what is parted.
  void partHingesAlong() {
    std::vector<bool> isLayer(state_.pattern.facets.size(), false);
    for (const FacetId f : request_.layers) isLayer[f.index] = true;
    const Rigid& frame = request_.frame;
    const std::size_t count = state_.pattern.edges.size();
    for (const Arc& arc : request_.chain) {
      if (arc.isCurved) continue;
      for (std::size_t e = 0; e < count; ++e) {
        const Edge& edge = state_.pattern.edges[e];
        const bool isJoint = edge.kind == EdgeKind::Hinge || edge.kind == EdgeKind::Tear;
        if (!isJoint || !isLayer[edge.left.index] || !isLayer[edge.right.index]) continue;
        const EdgeEnds ends{frame.apply(toFrame(edge.left, state_.pattern[edge.from])),
                            frame.apply(toFrame(edge.left, state_.pattern[edge.to]))};
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

  /// True when the facet shows its other side to whoever cuts.
  bool isTurned(FacetId facet) const { return dot(normalOf(facet), request_.frame.normal()) < 0; }
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
    return request_.frame.pullBack(state_.poseOf(facet).apply(paper));
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

  /// The facets that hold a place: in the plane of the cut, or below and above it among the layers.
  std::vector<FacetId> facetsUnder(Vec2 place) const {
    std::vector<FacetId> found;
    for (const FacetId f : ground()) {
      const Vec2 here = Onto(request_.frame, state_.poseOf(f))(place);
      if (locate(regionOf(state_.pattern, f), here, state_.tolerance().length()) != Where::Outside)
        found.push_back(f);
    }
    return found;
  }

  std::vector<FacetId> ground() const {
    if (request_.facet) return state_.layers.sets()[state_.layers.setOf(*request_.facet)].upward;
    std::vector<FacetId> facets;
    for (std::size_t f = 0; f < state_.pattern.facets.size(); ++f) {
      if (std::abs(dot(normalOf(FacetId(f)), request_.frame.normal())) > kUpright)
        facets.push_back(FacetId(f));
    }
    return facets;
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

  static constexpr double kUpright =
      1.0 / 4096;  ///< sine of the angle that still counts as upright

  FoldedState state_;
  const CutRequest& request_;
  std::vector<EdgeId> cuts_;  ///< the edges that this cut made or parted
};

}  // namespace

Result<FoldedState> cut(const FoldedState& state, const CutRequest& request) {
  return Cutting(state, request).run();
}

}  // namespace kiri
