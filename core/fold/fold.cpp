// SPDX-License-Identifier: MIT
#include "core/fold/fold.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/fold/moving_facets.h"
#include "core/fold/rotate.h"
#include "core/layers/divide_layers.h"
#include "core/paper/inscribe.h"

namespace kiri {
namespace {

class Folding {
 public:
  Folding(const FoldedState& state, const FoldRequest& request) : state_(state), request_(request) {
    const Rigid& pose = state.poseOf(request.line.facet);
    up_ = upOf(state, request.line.facet);
    axis_.point = pose.apply(request.line.from);
    axis_.axis = normalized(pose.direction(request.line.to - request.line.from));
    // A counter-clockwise turn about the axis lifts what lies on its left.
    if (!request.leftMoves) axis_.axis = -axis_.axis;
    axis_.degrees = request.isValley ? request.degrees : -request.degrees;
  }

  Result<FoldedState> run(Movements* record) {
    noteOldHinges();
    if (const Status made = crease(); !made) return made.error();
    if (hinges_.empty()) return missed();
    std::vector<FacetId> seeds;
    std::vector<FacetId> resting;
    for (const EdgeId id : hinges_) {
      const Edge& edge = state_.pattern[id];
      seeds.push_back(isLeftOnMovingSide(edge) ? edge.left : edge.right);
      resting.push_back(isLeftOnMovingSide(edge) ? edge.right : edge.left);
    }
    const MovingSet moving = movingFacets(state_, axis_, seeds, resting);
    if (!moving.broken.empty()) return stretched(moving);
    for (const Vec2 companion : request_.companions) {
      const std::optional<FacetId> facet = facetAt(state_.pattern, companion);
      if (!facet || !moving.moves[facet->index]) return left(companion);
    }
    ownHinges(moving.moves);
    return rotate(std::move(state_), moving.moves, axis_, record);
  }

 private:
  /// Existing hinges along the segment between two facets of the layers fold too, without a new
  /// crease.
  void noteOldHinges() {
    std::vector<bool> isLayer(state_.pattern.facets.size(), false);
    for (const FacetId f : request_.layers) isLayer[f.index] = true;
    const double span = distance(request_.line.from, request_.line.to);
    for (std::size_t e = 0; e < state_.pattern.edges.size(); ++e) {
      const Edge& edge = state_.pattern.edges[e];
      if (edge.kind != EdgeKind::Hinge || !isLayer[edge.left.index] || !isLayer[edge.right.index])
        continue;
      if (edge.angle != 0 || !liesOnAxis(state_, edge, axis_)) continue;
      const Rigid& pose = state_.poseOf(edge.left);
      const Vec3 origin = state_.poseOf(request_.line.facet).apply(request_.line.from);
      const Vec3 along = request_.leftMoves ? axis_.axis : -axis_.axis;
      const double s = dot(pose.apply(state_.pattern[edge.from]) - origin, along);
      const double t = dot(pose.apply(state_.pattern[edge.to]) - origin, along);
      const double shared = std::min(span, std::max(s, t)) - std::max(0.0, std::min(s, t));
      if (shared > state_.tolerance().length()) hinges_.push_back(EdgeId(e));
    }
  }

  /// Which way from the axis the moving paper lies.
  Vec3 movingSide() const { return cross(up_, axis_.axis); }

  bool isLeftOnMovingSide(const Edge& edge) const {
    const Vec2 along = state_.pattern[edge.to] - state_.pattern[edge.from];
    return dot(movingSide(), state_.poseOf(edge.left).direction(perpendicular(along))) > 0;
  }

  Status crease() {
    const std::size_t oldEdges = state_.pattern.edges.size();
    const Result<std::size_t> count =
        divideLayers(state_, request_.layers, [&](CreasePattern& pattern, FacetId facet) {
          const FacetLine line = lineOn(state_, request_.line, facet);
          return inscribeChords(pattern, facet, line.from, line.to, EdgeKind::Hinge);
        });
    if (!count) return count.error();
    for (std::size_t e = oldEdges; e < state_.pattern.edges.size(); ++e) {
      const Edge& edge = state_.pattern.edges[e];
      const bool isNew = edge.kind == EdgeKind::Hinge && !edge.line.isValid() && edge.angle == 0 &&
                         liesOnAxis(state_, edge, axis_);
      if (!isNew) continue;
      if (edge.left == edge.right) return dangling(EdgeId(e));
      hinges_.push_back(EdgeId(e));
    }
    return std::monostate{};
  }

  /// The new fold line takes the hinges; their signs say which way its own direction turns each of
  /// them.
  void ownHinges(const std::vector<bool>& moves) {
    const FoldLineId line(state_.lines.size());
    const double restored = request_.degrees > 0 ? request_.degrees : 180;
    state_.lines.push_back({request_.name, restored, request_.isValley});
    for (const EdgeId id : hinges_) {
      Edge& edge = state_.pattern[id];
      edge.line = line;
      edge.leftMoves = moves[edge.left.index];
      const int sign = turnSign(state_, edge, axis_, edge.leftMoves);
      edge.sign = static_cast<std::int8_t>(request_.isValley ? sign : -sign);
    }
  }

  Error missed() const {
    return {ErrorCode::MissesPaper,
            "the line from " + text(request_.line.from) + " to " + text(request_.line.to) +
                " mm crosses none of the layers to fold; draw it across the paper, or choose the "
                "layers under it",
            {{}, {{request_.line.from, request_.line.to}}, {}}};
  }

  Error dangling(EdgeId id) const {
    const Edge& edge = state_.pattern[id];
    const Vec2 middle = lerp(state_.pattern[edge.from], state_.pattern[edge.to], 0.5);
    return {ErrorCode::WouldStretch,
            "the crease at " + text(middle) +
                " mm ends at a hole, so its two sides stay joined around the hole; draw the line "
                "right across the "
                "paper",
            {{middle}, {{state_.pattern[edge.from], state_.pattern[edge.to]}}, {}}};
  }

  /// The first hinge on the way from the moving to the resting side that leads to paper beyond the
  /// line.
  EdgeId failingHinge(const MovingSet& moving) const {
    for (const EdgeId id : moving.broken) {
      const Edge& edge = state_.pattern[id];
      if (reachesBeyond(edge.left) || reachesBeyond(edge.right)) return id;
    }
    return moving.broken.front();
  }

  bool reachesBeyond(FacetId facet) const {
    for (const EdgeUse use : state_.pattern[facet].border) {
      const Vec3 p = state_.poseOf(facet).apply(state_.pattern[startOf(state_.pattern, use)]);
      if (dot(movingSide(), p - axis_.point) < -state_.tolerance().match()) return true;
    }
    return false;
  }

  Error stretched(const MovingSet& moving) const {
    const Edge& edge = state_.pattern[failingHinge(moving)];
    const Vec2 a = state_.pattern[edge.from];
    const Vec2 b = state_.pattern[edge.to];
    const std::string owner = edge.line.isValid()
                                  ? "the crease of \"" + state_.lines[edge.line.index].name + "\""
                                  : "the edge";
    return {ErrorCode::WouldStretch,
            "the fold would stretch the paper: " + owner + " from " + text(a) + " to " + text(b) +
                " mm joins moving and resting paper but is not on the fold line; fold the layers "
                "on both sides of it, "
                "or tear it first",
            {{a, b},
             {{a, b}},
             {interiorPointOf(state_.pattern, edge.left),
              interiorPointOf(state_.pattern, edge.right)}}};
  }

  Error left(Vec2 p) const {
    return {ErrorCode::NothingToDo,
            "the facet at " + text(p) +
                " mm was chosen to move but is not joined to the moving side of the line; choose "
                "facets that hang on "
                "the line",
            {{p}, {}, {p}}};
  }

  FoldedState state_;
  const FoldRequest& request_;
  Vec3 up_;
  Motion axis_;
  std::vector<EdgeId> hinges_;
};

}  // namespace

Vec3 upOf(const FoldedState& state, FacetId facet) {
  const Vec3 normal = state.poseOf(facet).normal();
  return normal.z < -kSamePlane ? -normal : normal;
}

Result<FoldedState> fold(const FoldedState& state, const FoldRequest& request, Movements* record) {
  return Folding(state, request).run(record);
}

}  // namespace kiri
