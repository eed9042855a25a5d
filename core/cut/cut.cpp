// SPDX-License-Identifier: MIT
#include "core/cut/cut.h"

#include <algorithm>
#include <optional>

#include "core/base/text.h"
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
    const std::size_t oldEdges = state_.pattern.edges.size();
    if (const Status done = divide(); !done) return done.error();
    const bool keepsAll = request_.keepSides.empty() && request_.keepPieces.empty();
    renewRests(state_);
    if (keepsAll) return std::move(state_);
    std::vector<bool> keep(state_.pattern.facets.size(), false);
    if (const Status done = keepPieces(keep); !done) return done.error();
    if (const Status done = keepSides(keep, oldEdges); !done) return done.error();
    if (std::find(keep.begin(), keep.end(), true) == keep.end()) {
      return Error{ErrorCode::NothingLeft,
                   "the cut would throw all paper away; name a place that is to stay",
                   {}};
    }
    return keepOnly(state_, keep);
  }

 private:
  Status divide() {
    const Rigid frame = state_.poseOf(request_.frame);
    const Result<std::size_t> count =
        divideLayers(state_, request_.layers, [&](CreasePattern& p, FacetId f) {
          const std::vector<Arc> chain = mapped(request_.chain, frame, state_.poses[f.index]);
          return Result<std::vector<NewEdge>>(inscribe(p, f, chain, EdgeKind::Cut));
        });
    if (!count) return count.error();
    if (*count == 0) {
      return Error{ErrorCode::MissesPaper,
                   "the cut from " + text(request_.chain.front().start) + " to " +
                       text(request_.chain.back().end) +
                       " mm crosses none of the chosen layers; draw it across the paper",
                   {{request_.chain.front().start, request_.chain.back().end}, {}, {}}};
    }
    return std::monostate{};
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
  std::vector<Sides> label(std::size_t oldEdges) const {
    std::vector<Sides> sides(state_.pattern.facets.size());
    std::vector<FacetId> queue;
    for (std::size_t e = oldEdges; e < state_.pattern.edges.size(); ++e) {
      const Edge& edge = state_.pattern.edges[e];
      if (edge.kind != EdgeKind::Cut || !isNewCut(edge)) continue;
      (isTurned(edge.left) ? sides[edge.left.index].isRight : sides[edge.left.index].isLeft) = true;
      (isTurned(edge.right) ? sides[edge.right.index].isLeft : sides[edge.right.index].isRight) =
          true;
      queue.push_back(edge.left);
      queue.push_back(edge.right);
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

  /// Halves of older cuts that this one crossed are among the new edges too; they do not lie on the
  /// chain.
  bool isNewCut(const Edge& edge) const {
    const Rigid& pose = state_.poseOf(edge.left);
    const EdgeId id(static_cast<std::size_t>(&edge - state_.pattern.edges.data()));
    const Vec2 middle =
        state_.poseOf(request_.frame).pullBack(pose.apply(pointAt(arcOf(state_.pattern, id), 0.5)));
    return std::any_of(request_.chain.begin(), request_.chain.end(), [&](const Arc& arc) {
      return nearestOn(arc, middle).distance <= state_.tolerance().match();
    });
  }

  Status keepSides(std::vector<bool>& keep, std::size_t oldEdges) const {
    if (request_.keepSides.empty()) return std::monostate{};
    const std::vector<Sides> sides = label(oldEdges);
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
};

}  // namespace

Result<FoldedState> cut(const FoldedState& state, const CutRequest& request) {
  return Cutting(state, request).run();
}

}  // namespace kiri
