// SPDX-License-Identifier: MIT
#include "core/fold/fold.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/fold/hinges_along.h"
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
    if (hinges_.empty()) {
      if (const Status turned = turnCreasesThere(); !turned) return turned.error();
    }
    std::vector<FacetId> seeds;
    std::vector<FacetId> resting;
    for (const Turned& turned : hinges_) {
      const Edge& edge = state_.pattern[turned.hinge];
      seeds.push_back(turned.leftMoves ? edge.left : edge.right);
      resting.push_back(turned.leftMoves ? edge.right : edge.left);
    }
    const MovingSet moving = movingFacets(state_, axis_, seeds, resting);
    if (!moving.broken.empty()) return stretched(moving);
    for (const Vec2 companion : request_.companions) {
      const std::optional<FacetId> facet = facetAt(state_.pattern, companion);
      if (!facet || !moving.moves[facet->index]) return left(companion);
    }
    if (turnsAsTheyAre_) addFellowHinges(moving.moves);
    ownHinges(moving.moves);
    return rotate(std::move(state_), moving.moves, axis_, record);
  }

 private:
  struct Turned {
    EdgeId hinge;
    bool leftMoves = false;
  };

  /// Existing hinges along the segment between two facets of the layers fold too, without a new
  /// crease.
  void noteOldHinges() {
    isLayer_.assign(state_.pattern.facets.size(), false);
    for (const FacetId f : request_.layers) isLayer_[f.index] = true;
    for (const EdgeId id : hingesAlong(state_, request_.line)) {
      const Edge& edge = state_.pattern[id];
      if (edge.angle != 0 || !isLayer_[edge.left.index] || !isLayer_[edge.right.index]) continue;
      hinges_.push_back({id, isOnMovingSide(edge, edge.left)});
    }
  }

  /// Where the line crosses no layer, creases that lie along it turn as they are, flat or folded:
  /// those between a chosen facet and one that is not.
  Status turnCreasesThere() {
    const std::vector<EdgeId> there = hingesAlong(state_, request_.line);
    for (const EdgeId id : there) {
      const Edge& edge = state_.pattern[id];
      const bool isLeftMeant = isMeant(edge.left, edge.right);
      if (isLeftMeant == isMeant(edge.right, edge.left)) continue;
      const FacetId meant = isLeftMeant ? edge.left : edge.right;
      if (isOnMovingSide(edge, meant)) {
        hinges_.push_back({id, isLeftMeant});
      } else if (isOnMovingSide(edge, across(edge, meant))) {
        hinges_.push_back({id, !isLeftMeant});
      }
    }
    if (hinges_.empty()) return missed(there);
    turnsAsTheyAre_ = true;
    bent_ = bentBy(hinges_.front());
    for (const Turned& turned : hinges_) {
      if (std::abs(bentBy(turned) - bent_) > kSameAngle) return unlike(turned.hinge);
    }
    return std::monostate{};
  }

  /// Creases on the axis that paper joined to the moving side takes along, folded alike.
  void addFellowHinges(const std::vector<bool>& moves) {
    hinges_.clear();
    for (std::size_t e = 0; e < state_.pattern.edges.size(); ++e) {
      const Edge& edge = state_.pattern.edges[e];
      if (edge.kind != EdgeKind::Hinge || moves[edge.left.index] == moves[edge.right.index])
        continue;
      const Turned turned{EdgeId(e), moves[edge.left.index]};
      if (std::abs(bentBy(turned) - bent_) <= kSameAngle) hinges_.push_back(turned);
    }
  }

  /// A facet of the layers; where both sides of a crease are, one that was told to move.
  bool isMeant(FacetId facet, FacetId other) const {
    if (!isLayer_[facet.index] || !isLayer_[other.index]) return isLayer_[facet.index];
    return std::any_of(request_.companions.begin(), request_.companions.end(),
                       [&](Vec2 companion) { return facetAt(state_.pattern, companion) == facet; });
  }

  /// Degrees about the axis by which a hinge is folded already.
  double bentBy(const Turned& turned) const {
    const Edge& edge = state_.pattern[turned.hinge];
    return edge.angle * turnSign(state_, edge, axis_, turned.leftMoves);
  }

  /// True when the facet leaves the edge towards the side of the line that moves.
  bool isOnMovingSide(const Edge& edge, FacetId facet) const {
    const Vec2 along = state_.pattern[edge.to] - state_.pattern[edge.from];
    const Vec2 inward = facet == edge.left ? perpendicular(along) : -perpendicular(along);
    return dot(movingSide(), state_.poseOf(facet).direction(normalized(inward))) > kSamePlane;
  }

  /// Which way from the axis the moving paper lies.
  Vec3 movingSide() const { return cross(up_, axis_.axis); }

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
      hinges_.push_back({EdgeId(e), isOnMovingSide(edge, edge.left)});
    }
    return std::monostate{};
  }

  /// The new fold line takes the hinges; their signs say which way its own direction turns each of
  /// them. Creases that were folded before keep the direction in which they are folded now, or were
  /// before the fold has opened them.
  void ownHinges(const std::vector<bool>& moves) {
    const FoldLineId line(state_.lines.size());
    double reached = bent_ + axis_.degrees;
    if (std::abs(reached) > 180) reached += reached > 0 ? -360 : 360;
    double restored = std::abs(reached) > kSameAngle ? reached : bent_;
    if (restored == 0) restored = request_.isValley ? 180 : -180;
    const bool isValley = restored > 0;
    state_.lines.push_back({request_.name, std::abs(restored), isValley});
    for (const Turned& turned : hinges_) {
      Edge& edge = state_.pattern[turned.hinge];
      edge.line = line;
      edge.leftMoves = moves[edge.left.index];
      const int sign = turnSign(state_, edge, axis_, edge.leftMoves);
      edge.sign = static_cast<std::int8_t>(isValley ? sign : -sign);
    }
  }

  std::string drawn() const {
    return "the line from " + text(request_.line.from) + " to " + text(request_.line.to) + " mm";
  }

  Error missed(const std::vector<EdgeId>& there) const {
    Error error{ErrorCode::MissesPaper,
                drawn() + " crosses none of the layers to fold; ",
                {{}, {{request_.line.from, request_.line.to}}, {}}};
    if (there.empty()) {
      error.message += "draw it across the paper, or choose the layers under it";
      return error;
    }
    const Edge& edge = state_.pattern[there.front()];
    const bool hasName = edge.line.isValid();
    const std::string name = hasName ? "\"" + state_.lines[edge.line.index].name + "\"" : "";
    error.message += (hasName ? "the crease of " + name : std::string("an edge")) +
                     " lies along it, folded by " + text(std::abs(edge.angle)) +
                     " degrees: to turn the paper there, choose the layers on one side of that "
                     "crease, and the side of the line on which they lie";
    if (hasName) error.message += "; to turn all of " + name + ", set its angle";
    return error;
  }

  Error unlike(EdgeId id) const {
    const Edge& edge = state_.pattern[id];
    const Vec2 a = state_.pattern[edge.from];
    const Vec2 b = state_.pattern[edge.to];
    return {ErrorCode::BadValue,
            drawn() +
                " lies along creases that are folded by different angles, such as the one "
                "from " +
                text(a) + " to " + text(b) +
                " mm; choose layers that are folded alike, and fold the others after them",
            {{a, b}, {{a, b}}, {}}};
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
  std::vector<bool> isLayer_;
  std::vector<Turned> hinges_;
  bool turnsAsTheyAre_ = false;  ///< creases that were there, and nothing is creased
  double bent_ = 0;              ///< degrees about the axis by which all of them are folded already
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
