// SPDX-License-Identifier: MIT
#include "core/fold/rotate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/fold/collision_text.h"
#include "core/layers/hinge_checks.h"
#include "core/sweep/sweep.h"

namespace kiri {
namespace {

/// Angles that ought to be 0, 90 or 180 are: sums of user angles carry rounding.
double tidied(double degrees) {
  const double step = 90 * std::round(degrees / 90);
  return std::abs(degrees - step) <= kSameAngle ? step : degrees;
}

/// Turns the hinges between moving and resting facets; tells which would turn through themselves.
std::vector<Contact> turnHinges(FoldedState& state, const std::vector<bool>& moves,
                                const Motion& motion) {
  std::vector<Contact> contacts;
  for (Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    const bool leftMoves = moves[edge.left.index];
    if (leftMoves == moves[edge.right.index]) continue;
    double angle = tidied(edge.angle + turnSign(state, edge, motion, leftMoves) * motion.degrees);
    if (std::abs(angle) > 180) {
      angle = tidied(angle > 0 ? angle - 360 : angle + 360);
      if (contacts.size() < kMostContacts) {
        contacts.push_back({CollisionMoment::Hinge, leftMoves ? edge.left : edge.right,
                            leftMoves ? edge.right : edge.left});
      }
    }
    edge.angle = angle;
  }
  return contacts;
}

bool isFlatAngle(double degrees) { return degrees == 0 || std::abs(degrees) == 180; }

/// Hinges between moving and resting facets that stood open and lie flat now.
std::vector<EdgeId> closedHinges(const FoldedState& before, const FoldedState& after,
                                 const std::vector<bool>& moves) {
  std::vector<EdgeId> closed;
  for (std::size_t e = 0; e < after.pattern.edges.size(); ++e) {
    const Edge& edge = after.pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge || moves[edge.left.index] == moves[edge.right.index]) continue;
    if (!isFlatAngle(before.pattern.edges[e].angle) && isFlatAngle(edge.angle))
      closed.push_back(EdgeId(e));
  }
  return closed;
}

/// Paper that the closing of an open fold has caught in its crease. Fresh folds need no such check:
/// what lies across their axis is creased or refused.
void checkClosed(const FoldedState& before, const FoldedState& after,
                 const std::vector<bool>& moves, const Motion& motion,
                 std::vector<Contact>& contacts) {
  const std::vector<EdgeId> closed = closedHinges(before, after, moves);
  if (closed.empty()) return;
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const EdgeId id : closed) {
    const Edge& edge = after.pattern[id];
    for (const VertexId v : {edge.from, edge.to}) {
      const Vec3 p = after.poseOf(edge.left).apply(after.pattern[v]);
      low = std::min(low, dot(motion.axis, p - motion.point));
      high = std::max(high, dot(motion.axis, p - motion.point));
    }
  }
  const Vec3 from = motion.point + motion.axis * low;
  const Vec3 to = motion.point + motion.axis * high;
  const std::vector<FacetId>& layers =
      after.layers.sets()[after.layers.setOf(after.pattern[closed.front()].left)].upward;
  const bool isCrossed = std::any_of(layers.begin(), layers.end(), [&](FacetId f) {
    return runsThrough(after.pattern, after.poseOf(f), f, from, to);
  });
  if (!isCrossed) return;
  std::size_t found = 0;
  for (const EdgeId id : closed) {
    const Edge& edge = after.pattern[id];
    const std::optional<FacetId> caught = facetThrough(after, edge);
    if (!caught) continue;
    const FacetId mover = moves[edge.left.index] ? edge.left : edge.right;
    contacts.push_back({CollisionMoment::End, mover, *caught});
    if (++found >= kMostContacts) return;
  }
}

/// Hinges, poses and layer order after the motion, and what gets in the way as it begins and ends.
FoldedState afterTurn(const FoldedState& state, const std::vector<bool>& moves,
                      const Motion& motion, std::vector<Contact>& contacts) {
  FoldedState after = state;
  contacts = turnHinges(after, moves, motion);
  const Rigid rotation = rotationAbout(motion.point, motion.axis, motion.degrees);
  for (Rest& rest : after.rests) {
    if (moves[rest.facet.index]) rest.pose = compose(rotation, rest.pose);
  }
  after.poses = derivePoses(after.pattern, after.rests);
  Relayered relayered = relayer(state, moves, motion, after.poses);
  after.layers = std::move(relayered.order);
  contacts.insert(contacts.end(), relayered.contacts.begin(), relayered.contacts.end());
  return after;
}

/// Appends what the motion meets, in the order in which it happens.
void noteCollisions(const Turned& turned, const std::vector<Contact>& contacts,
                    std::vector<Collision>& collisions) {
  // `collisions` may belong to the state that describes them, so they are written first.
  std::vector<Collision> met;
  bool startsWrong = false;
  for (const Contact& contact : contacts) {
    startsWrong = startsWrong || contact.moment == CollisionMoment::Start;
    if (contact.moment != CollisionMoment::End) met.push_back(described(turned, contact));
  }
  // What is wrong from the start says nothing new on the way.
  if (!startsWrong) {
    const SweepReport report = sweep(turned.before, turned.moves, turned.motion);
    if (report.verdict != SweepVerdict::Free) met.push_back(described(turned, report));
  }
  for (const Contact& contact : contacts) {
    if (contact.moment == CollisionMoment::End) met.push_back(described(turned, contact));
  }
  std::move(met.begin(), met.end(), std::back_inserter(collisions));
}

}  // namespace

int turnSign(const FoldedState& state, const Edge& edge, const Motion& motion, bool leftMoves) {
  const Vec2 along = state.pattern[edge.to] - state.pattern[edge.from];
  const bool sameWay = dot(state.poseOf(edge.left).direction(along), motion.axis) > 0;
  return sameWay == leftMoves ? 1 : -1;
}

FoldedState rotate(FoldedState state, const std::vector<bool>& moves, const Motion& motion,
                   Movements* record) {
  if (motion.degrees == 0) return state;
  std::vector<Contact> contacts;
  FoldedState after = afterTurn(state, moves, motion, contacts);
  checkClosed(state, after, moves, motion, contacts);
  noteCollisions({state, after, moves, motion}, contacts, after.collisions);
  if (record != nullptr) {
    record->push_back(
        {std::make_shared<const FoldedState>(std::move(state)), Turning{moves, motion}});
  }
  return after;
}

FoldedState turned(FoldedState state, const std::vector<bool>& moves, const Motion& motion) {
  if (motion.degrees == 0) return state;
  std::vector<Contact> unasked;
  return afterTurn(state, moves, motion, unasked);
}

FoldedState placed(FoldedState state, const Rigid& motion) {
  for (Rest& rest : state.rests) rest.pose = compose(motion, rest.pose);
  state.poses = derivePoses(state.pattern, state.rests);
  std::vector<LayerSet> sets = state.layers.sets();
  for (LayerSet& set : sets) set.normal = motion.direction(set.normal);
  state.layers = LayerOrder(std::move(sets));
  return state;
}

}  // namespace kiri
