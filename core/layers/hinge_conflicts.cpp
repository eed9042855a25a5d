// SPDX-License-Identifier: MIT
#include "core/layers/hinge_conflicts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/layers/hinge_checks.h"
#include "core/paper/inscribe.h"

namespace kiri {
namespace {

/// How the paper of one side of a line goes on at the line.
struct Passage {
  enum class Kind {
    Through,  ///< straight on, to the other side
    Taco,     ///< back on the same side
    Up,       ///< out of the plane, along its normal
    Down
  };
  Kind kind = Kind::Through;
  FacetId first;    ///< on this side
  FacetId second;   ///< where the paper goes on
  double turn = 0;  ///< Up, Down: degrees away from straight on
};

/// A hinge as a segment of the plane, with how it is passed from its left and from its right.
struct Run {
  EdgeId edge;
  Vec2 from;
  Vec2 along;  ///< unit
  double span = 0;
  int kind = 0;  ///< 0 rests, 1 moves, 2: joins moving to resting paper
  std::optional<Passage> left;
  std::optional<Passage> right;

  const std::optional<Passage>& on(bool isLeft) const { return isLeft ? left : right; }
};

class Conflicts {
 public:
  Conflicts(const CreasePattern& pattern, const std::vector<Rigid>& poses, const LayerOrder& order,
            std::size_t set, const ConflictScope& scope)
      : pattern_(pattern),
        poses_(poses),
        order_(order),
        set_(set),
        layers_(order.sets()[set]),
        scope_(scope),
        reference_(poses[layers_.upward.front().index]),
        isMirrored_(dot(reference_.normal(), layers_.normal) < 0) {}

  std::vector<HingeConflict> run() {
    gatherRuns();
    if (scope_.only.isValid()) {
      for (const Run& run : runs_) {
        if (run.edge == scope_.only) compareAll({run}, runs_, layers_.upward);
      }
    } else if (scope_.moves.empty()) {
      compareAll(runs_, runs_, layers_.upward);
    } else {
      compareMoved();
    }
    return std::move(found_);
  }

 private:
  bool isFull() const { return found_.size() >= scope_.most; }
  bool isHere(FacetId f) const { return order_.setOf(f) == set_; }

  /// Plane coordinates, counter-clockwise seen against the normal of the set.
  Vec2 toPlane(Vec3 p) const { return seen(reference_.pullBack(p)); }
  Vec2 seen(Vec2 p) const { return isMirrored_ ? Vec2{-p.x, p.y} : p; }

  void compareAll(const std::vector<Run>& some, const std::vector<Run>& others,
                  const std::vector<FacetId>& facets) {
    for (const Run& a : some) {
      for (const Run& b : others) {
        if (isFull()) return;
        if (a.edge != b.edge) compare(a, b);
      }
      for (const FacetId f : facets) {
        if (isFull()) return;
        compare(a, f);
      }
    }
  }

  /// Hinges between moving and resting paper lie on the axis, turn alike, and stay right among
  /// themselves. The others matter to paper of the other kind, and those on the axis to these.
  void compareMoved() {
    std::vector<Run> parts[3];
    std::vector<FacetId> facets[2];
    for (const Run& run : runs_) parts[static_cast<std::size_t>(run.kind)].push_back(run);
    for (const FacetId f : layers_.upward) facets[scope_.moves[f.index] ? 1 : 0].push_back(f);
    compareAll(parts[0], parts[1], facets[1]);
    compareAll(parts[1], {}, facets[0]);
    if (parts[2].empty()) return;
    const Run& axis = parts[2].front();
    const double near = pattern_.tolerance.match();
    std::vector<Run> along;
    std::vector<FacetId> across;
    for (std::size_t kind = 0; kind < 2; ++kind) {
      for (const Run& run : parts[kind]) {
        if (liesAlong(axis, run)) along.push_back(run);
      }
      for (const FacetId f : facets[kind]) {
        const auto [low, high] = heightsOf(f, axis);
        if (low < -near && high > near) across.push_back(f);
      }
    }
    compareAll(parts[2], along, across);
  }

  void gatherRuns() {
    std::vector<bool> isSeen(pattern_.edges.size(), false);
    for (const FacetId f : layers_.upward) {
      for (const EdgeUse use : pattern_[f].border) {
        const Edge& edge = pattern_[use.edge];
        if (edge.kind != EdgeKind::Hinge || edge.left == edge.right || isSeen[use.edge.index])
          continue;
        isSeen[use.edge.index] = true;
        add(use.edge);
      }
    }
  }

  void add(EdgeId id) {
    const Edge& edge = pattern_[id];
    const Rigid& pose = poses_[(isHere(edge.left) ? edge.left : edge.right).index];
    Run run;
    run.edge = id;
    run.from = toPlane(pose.apply(pattern_[edge.from]));
    const Vec2 to = toPlane(pose.apply(pattern_[edge.to]));
    run.span = distance(run.from, to);
    run.along = (to - run.from) / run.span;
    if (!scope_.moves.empty()) {
      const bool leftMoves = scope_.moves[edge.left.index];
      run.kind = leftMoves != scope_.moves[edge.right.index] ? 2 : leftMoves ? 1 : 0;
    }
    if (isHere(edge.left)) place(run, edge, true);
    if (isHere(edge.right)) place(run, edge, false);
    runs_.push_back(run);
  }

  /// Notes how the paper of one facet of the edge, which lies in the plane, goes on.
  void place(Run& run, const Edge& edge, bool ofLeft) const {
    const FacetId own = ofLeft ? edge.left : edge.right;
    const FacetId other = ofLeft ? edge.right : edge.left;
    const bool isFrontUp = dot(poses_[own.index].normal(), layers_.normal) > 0;
    // Seen from its front, the left facet lies left of the edge; seen from the back, right of it.
    const bool isLeft = ofLeft == isFrontUp;
    // Angles are taken from the poses: the pattern may hold those of another moment.
    const Vec2 across = perpendicular(normalized(pattern_[edge.to] - pattern_[edge.from]));
    const Vec3 straightOn = poses_[own.index].direction(ofLeft ? -across : across);
    const Vec3 on = poses_[other.index].direction(ofLeft ? -across : across);
    Passage passage{Passage::Kind::Through, own, other, 0};
    if (isHere(other)) {
      if (dot(on, straightOn) < 0) passage.kind = Passage::Kind::Taco;
    } else {
      const double rise = dot(on, layers_.normal);
      passage.kind = rise > 0 ? Passage::Kind::Up : Passage::Kind::Down;
      passage.turn = angleDegrees(dot(on, straightOn), std::abs(rise));
    }
    (isLeft ? run.left : run.right) = passage;
  }

  bool concerns(const Passage& a, const Passage& b) const {
    if (scope_.moves.empty()) return true;
    const bool moves = scope_.moves[a.first.index];
    return scope_.moves[a.second.index] != moves || scope_.moves[b.first.index] != moves ||
           scope_.moves[b.second.index] != moves;
  }

  void check(const Passage& a, const Passage& b) {
    if (isFull() || !concerns(a, b) || (agree(a, b) && agree(b, a))) return;
    found_.push_back({{a.first, a.second}, {b.first, b.second}});
  }

  /// Whether the second run lies in the line of the first.
  bool liesAlong(const Run& a, const Run& b) const {
    const double near = pattern_.tolerance.match();
    const Vec2 between = b.from - a.from;
    return std::abs(cross(a.along, between)) <= near &&
           std::abs(cross(a.along, between + b.along * b.span)) <= near;
  }

  /// Two hinges along one line.
  void compare(const Run& a, const Run& b) {
    const double near = pattern_.tolerance.match();
    if (!liesAlong(a, b)) return;
    const double s = dot(a.along, b.from - a.from);
    const bool isSameWay = dot(a.along, b.along) > 0;
    const double t = isSameWay ? s + b.span : s - b.span;
    if (std::min(a.span, std::max(s, t)) - std::max(0.0, std::min(s, t)) <= near) return;
    for (const bool isLeft : {true, false}) {
      const auto& first = a.on(isLeft);
      const auto& second = b.on(isLeft == isSameWay);
      if (first && second) check(*first, *second);
    }
  }

  /// A hinge and a facet through which it may run.
  void compare(const Run& run, FacetId f) {
    const Passage through{Passage::Kind::Through, f, f, 0};
    const bool isWrong = (run.left && isConflict(*run.left, through)) ||
                         (run.right && isConflict(*run.right, through));
    if (!isWrong) return;
    const double near = pattern_.tolerance.match();
    const auto [low, high] = heightsOf(f, run);
    if (low >= -near || high <= near) return;
    const Rigid& pose = poses_[f.index];
    if (!runsThrough(pattern_, pose, f, fromPlane(run.from),
                     fromPlane(run.from + run.along * run.span)))
      return;
    for (const auto* passage : {&run.left, &run.right}) {
      if (*passage) check(**passage, through);
    }
  }

  bool isConflict(const Passage& a, const Passage& through) const {
    return concerns(a, through) && (!agree(a, through) || !agree(through, a));
  }

  Vec3 fromPlane(Vec2 p) const { return reference_.apply(seen(p)); }

  /// How far corners of a facet, and controls of its border, lie right (below 0) and left of the
  /// line of a run.
  std::pair<double, double> heightsOf(FacetId f, const Run& run) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const Vec2 p : cornersOf(f)) {
      const double height = cross(run.along, p - run.from);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return {low, high};
  }

  const std::vector<Vec2>& cornersOf(FacetId f) {
    if (corners_.empty()) corners_.resize(pattern_.facets.size());
    std::vector<Vec2>& corners = corners_[f.index];
    if (!corners.empty()) return corners;
    const Rigid& pose = poses_[f.index];
    for (const EdgeUse use : pattern_[f].border) {
      const Arc arc = arcOf(pattern_, use);
      corners.push_back(toPlane(pose.apply(arc.start)));
      if (!arc.isCurved) continue;
      corners.push_back(toPlane(pose.apply(arc.control1)));
      corners.push_back(toPlane(pose.apply(arc.control2)));
    }
    return corners;
  }

  bool isAbove(FacetId a, FacetId b) const { return order_.isAbove(a, b); }
  bool isBetween(FacetId f, const Passage& taco) const {
    return isAbove(f, taco.first) != isAbove(f, taco.second);
  }

  /// Whether two runs of paper that are seen from the same side of a line get past each other;
  /// rules that are the other way round hold for the pair in the other order.
  bool agree(const Passage& a, const Passage& b) const {
    using Kind = Passage::Kind;
    if (a.first == b.first || a.second == b.second) return true;
    if (b.kind == Kind::Taco && (a.first == b.second || a.second == b.first)) return true;
    if (a.kind == Kind::Taco && (b.first == a.second || b.second == a.first)) return true;
    if (b.kind == Kind::Taco) {
      return a.kind == Kind::Taco ? isBetween(a.first, b) == isBetween(a.second, b)
                                  : !isBetween(a.first, b);
    }
    if (a.kind == Kind::Through || a.kind == Kind::Taco) {
      return a.kind != Kind::Through || b.kind != Kind::Through ||
             isAbove(a.first, b.first) == isAbove(a.second, b.second);
    }
    const bool isUp = a.kind == Kind::Up;
    const bool isBeyond = isUp ? isAbove(a.first, b.first) : isAbove(b.first, a.first);
    if (a.kind != b.kind) return isBeyond;
    if (std::abs(a.turn - b.turn) > kAlike) return a.turn < b.turn || isBeyond;
    return isBeyond ? isTied(a, b) : isTied(b, a);
  }

  /// Of two facets that stand at the same angle, the one that is outside in the plane of the set
  /// must be so in the plane in which they stand.
  bool isTied(const Passage& outer, const Passage& inner) const {
    if (!order_.areCoplanar(outer.second, inner.second)) return true;
    const Vec3 up = order_.sets()[order_.setOf(outer.second)].normal;
    // The normal of this set, carried along the paper into the other plane.
    const bool isFrontUp = dot(poses_[outer.first.index].normal(), layers_.normal) > 0;
    const bool agrees = (dot(poses_[outer.second.index].normal(), up) > 0) == isFrontUp;
    const bool isUpper = isAbove(outer.first, inner.first);
    return isAbove(outer.second, inner.second) == (isUpper == agrees);
  }

  /// Fold angles that make one plane, in degrees; as wide as kSamePlane is in directions.
  static constexpr double kAlike = 180 / 3.14159 * kSamePlane;

  const CreasePattern& pattern_;
  const std::vector<Rigid>& poses_;
  const LayerOrder& order_;
  std::size_t set_;
  const LayerSet& layers_;
  const ConflictScope& scope_;
  const Rigid& reference_;
  bool isMirrored_;
  std::vector<Run> runs_;
  std::vector<std::vector<Vec2>> corners_;
  std::vector<HingeConflict> found_;
};

}  // namespace

std::vector<HingeConflict> hingeConflicts(const CreasePattern& pattern,
                                          const std::vector<Rigid>& poses, const LayerOrder& order,
                                          std::size_t set, const ConflictScope& scope) {
  return Conflicts(pattern, poses, order, set, scope).run();
}

}  // namespace kiri
