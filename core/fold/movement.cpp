// SPDX-License-Identifier: MIT
#include "core/fold/movement.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/fold/rotate.h"
#include "core/layers/order_by_height.h"

namespace kiri {
namespace {

/// The turn that takes one direction of space to another: axis and degrees.
struct Turn {
  Vec3 axis{0, 0, 1};
  double degrees = 0;
};

Turn turnBetween(const Rigid& from, const Rigid& to) {
  const Rigid back{{from.x.x, from.y.x, from.z.x},
                   {from.x.y, from.y.y, from.z.y},
                   {from.x.z, from.y.z, from.z.z},
                   {}};
  const Rigid r = compose(Rigid{to.x, to.y, to.z, {}}, back);
  const Vec3 twice{r.y.z - r.z.y, r.z.x - r.x.z, r.x.y - r.y.x};
  const double degrees = angleDegrees(r.x.x + r.y.y + r.z.z - 1, length(twice));
  if (length(twice) > kSamePlane) return {normalized(twice), degrees};
  if (degrees < 90) return {};
  // Half a turn: any column of r + 1 lies along the axis; the longest is the most exact.
  const Vec3 columns[] = {r.x + Vec3{1, 0, 0}, r.y + Vec3{0, 1, 0}, r.z + Vec3{0, 0, 1}};
  const Vec3* longest = &columns[0];
  for (const Vec3& column : columns) {
    if (length(column) > length(*longest)) longest = &column;
  }
  return {normalized(*longest), degrees};
}

Rigid between(const Rigid& from, const Rigid& to, double part) {
  if (from == to || part <= 0) return from;
  if (part >= 1) return to;
  const Turn turn = turnBetween(from, to);
  const Rigid rotation = rotationAbout({}, turn.axis, turn.degrees * part);
  const Rigid turned = compose(rotation, Rigid{from.x, from.y, from.z, {}});
  return {turned.x, turned.y, turned.z, from.origin + (to.origin - from.origin) * part};
}

double apart(const CreasePattern& pattern, FacetId facet, const Rigid& a, const Rigid& b) {
  double most = 0;
  for (const EdgeUse use : pattern[facet].border) {
    const Vec2 p = pattern[startOf(pattern, use)];
    most = std::max(most, distance(a.apply(p), b.apply(p)));
  }
  return most;
}

void setAngles(CreasePattern& pattern, const FoldAngles& angles) {
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    if (pattern.edges[e].kind == EdgeKind::Hinge) pattern.edges[e].angle = angles[e];
  }
}

/// Poses of the movement when `part` is done; the angles of `pattern` are set to those of then.
std::vector<Rigid> posesDuring(const Unfolding& how, CreasePattern& pattern, double part) {
  setAngles(pattern, how.path->at(std::min(part, how.path->reach())));
  std::vector<Rest> rests = how.from;
  for (std::size_t i = 0; i < rests.size(); ++i)
    rests[i].pose = between(how.from[i].pose, how.to[i].pose, part);
  return derivePoses(pattern, rests);
}

FoldedState during(const FoldedState& start, const Turning& how, double part) {
  Motion motion = how.motion;
  motion.degrees *= part;
  return turned(start, how.moves, motion);
}

FoldedState during(const FoldedState& start, const Unfolding& how, double part) {
  constexpr double kMomentBefore = 1.0 / 128;
  if (part <= 0) return start;
  FoldedState state = start;
  const std::vector<Rigid> before =
      posesDuring(how, state.pattern, std::max(0.0, part - kMomentBefore));
  state.poses = posesDuring(how, state.pattern, part);
  state.layers = orderByHeight(start, state.poses, before);
  for (Rest& rest : state.rests) rest.pose = state.poseOf(rest.facet);
  return state;
}

FoldedState during(const FoldedState& start, const Carrying& how, double part) {
  const Rigid rotation =
      rotationAbout(how.motion.point, how.motion.axis, how.motion.degrees * part);
  return placed(start, compose(translation(how.by * part), rotation));
}

double degreesOf(const Turning& how) { return std::abs(how.motion.degrees); }
double degreesOf(const Carrying& how) { return std::abs(how.motion.degrees); }
double degreesOf(const Unfolding& how) {
  const FoldAngles first = how.path->at(0);
  const FoldAngles last = how.path->at(how.path->reach());
  double most = 0;
  for (std::size_t e = 0; e < first.size(); ++e)
    most = std::max(most, std::abs(last[e] - first[e]));
  return most;
}

}  // namespace

double degreesOf(const Movement& movement) {
  return std::visit([](const auto& how) { return degreesOf(how); }, movement.how);
}

FoldedState stateDuring(const Movement& movement, double part) {
  return std::visit([&](const auto& how) { return during(*movement.start, how, part); },
                    movement.how);
}

double degreesOf(const Movements& movements) {
  double degrees = 0;
  for (const Movement& movement : movements) degrees += degreesOf(movement);
  return degrees;
}

FoldedState stateAlong(const Movements& movements, double part) {
  KIRI_CHECK(!movements.empty(), "there is a way to be along");
  const double degrees = degreesOf(movements);
  double left = part * degrees;
  for (const Movement& movement : movements) {
    const double share = degreesOf(movement);
    if (left <= share && share > 0) return stateDuring(movement, left / share);
    left -= share;
  }
  // A shift goes as far as it is asked; else rounding has left a trifle beyond the last turn.
  return stateDuring(movements.back(), degrees > 0 ? 1 : part);
}

std::vector<Rigid> posesDuring(const Movement& movement, double part) {
  CreasePattern pattern = movement.start->pattern;
  return posesDuring(std::get<Unfolding>(movement.how), pattern, part);
}

Movement movementAlong(const FoldedState& start, std::shared_ptr<const RigidPath> path,
                       const FoldedState& end) {
  Unfolding how{std::move(path), start.rests, {}};
  const std::vector<std::uint32_t> piece = piecesOf(start.pattern);
  for (Rest& rest : how.from) {
    FacetId held = rest.facet;
    double least = apart(start.pattern, held, start.poseOf(held), end.poseOf(held));
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const FacetId f(i);
      if (piece[i] != piece[rest.facet.index]) continue;
      const double moved = apart(start.pattern, f, start.poseOf(f), end.poseOf(f));
      if (moved >= least) continue;
      least = moved;
      held = f;
    }
    rest = {held, start.poseOf(held)};
    const bool stays = least <= start.tolerance().match();
    how.to.push_back({held, stays ? rest.pose : end.poseOf(held)});
  }
  return {std::make_shared<const FoldedState>(start), std::move(how)};
}

}  // namespace kiri
