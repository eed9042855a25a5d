// SPDX-License-Identifier: MIT
#include "core/fold/collision_text.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/fold/rotate.h"

namespace kiri {
namespace {

constexpr std::size_t kMostNames = 3;

/// The folded lines whose creases bound the flat paper that a facet is part of, newest first: what
/// to unfold to get it out of the way. Lines between moving and resting paper are left out.
std::vector<std::string> holders(const Turned& turned, FacetId facet) {
  const CreasePattern& pattern = turned.before.pattern;
  std::vector<bool> isSeen(pattern.facets.size(), false);
  std::vector<bool> holds(turned.before.lines.size(), false);
  std::vector<FacetId> queue = {facet};
  isSeen[facet.index] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const EdgeUse use : pattern[queue[i]].border) {
      const Edge& edge = pattern[use.edge];
      if (edge.kind != EdgeKind::Hinge) continue;
      const FacetId next = across(edge, queue[i]);
      if (turned.moves[next.index] != turned.moves[facet.index]) continue;
      if (edge.angle != 0) {
        if (edge.line.isValid()) holds[edge.line.index] = true;
      } else if (!isSeen[next.index]) {
        isSeen[next.index] = true;
        queue.push_back(next);
      }
    }
  }
  std::vector<std::string> names;
  for (std::size_t l = holds.size(); l-- > 0 && names.size() < kMostNames;) {
    if (holds[l]) names.push_back("\"" + turned.before.lines[l].name + "\"");
  }
  return names;
}

/// "unfold "B" or "A" first, " or nothing.
std::string unfoldFirst(const Turned& turned, FacetId obstacle) {
  std::string names;
  for (const std::string& name : holders(turned, obstacle))
    names += (names.empty() ? "" : " or ") + name;
  return names.empty() ? "" : "unfold " + names + " first, ";
}

std::string placeText(Vec3 p) {
  return "(" + kiri::text(p.x) + ", " + kiri::text(p.y) + ", " + kiri::text(p.z) + ")";
}

std::string sentence(const Turned& turned, const Contact& contact, const Collision& c) {
  const std::string moving = "the paper at " + kiri::text(c.moving) + " mm";
  const std::string fixed = "the paper at " + kiri::text(c.fixed) + " mm";
  switch (contact.moment) {
    case CollisionMoment::Start:
      return "as the motion begins, " + moving + " lies on the wrong side of " + fixed +
             " and would pass through it; " + unfoldFirst(turned, contact.fixed) +
             "fold the other way, choose fewer layers, or tear the paper there";
    case CollisionMoment::End:
      return "as the motion ends, " + moving + " would pass through " + fixed +
             ", on which it lands; " + unfoldFirst(turned, contact.fixed) +
             "fold fewer layers, lay flat what stands in the way, or tear here";
    case CollisionMoment::Hinge:
      return "the crease between " + moving + " and at " + kiri::text(c.fixed) +
             " mm would turn past 180 degrees, through itself; unfold it first";
    case CollisionMoment::During:
      break;
  }
  return "when the fold is at " + kiri::text(c.degrees) + " degrees, " + moving +
         (c.isCertain ? " meets " : " comes so near ") + (c.isCertain ? fixed : "to " + fixed) +
         (c.isCertain ? ", and would pass through it" : " that it may pass through it") + " at " +
         placeText(c.place) + " mm of the model; " + unfoldFirst(turned, contact.fixed) +
         "fold fewer layers, stop before that angle, or tear the paper there";
}

Collision noted(const Turned& turned, const Contact& contact, double degrees, Vec3 place,
                bool isCertain) {
  Collision c;
  c.moment = contact.moment;
  c.moving = interiorPointOf(turned.after.pattern, contact.moving);
  c.fixed = interiorPointOf(turned.after.pattern, contact.fixed);
  c.degrees = degrees;
  c.place = place;
  c.isCertain = isCertain;
  c.message = sentence(turned, contact, c);
  return c;
}

}  // namespace

double amountAfter(const Turned& turned, double degrees) {
  const FoldedState& state = turned.before;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || !edge.line.isValid()) continue;
    const bool leftMoves = turned.moves[edge.left.index];
    if (leftMoves == turned.moves[edge.right.index]) continue;
    const int sign = turnSign(state, edge, turned.motion, leftMoves);
    return edge.sign * (edge.angle + sign * degrees);
  }
  return std::abs(degrees);
}

Collision described(const Turned& turned, const Contact& contact) {
  const bool isAtStart = contact.moment == CollisionMoment::Start;
  const FoldedState& state = isAtStart ? turned.before : turned.after;
  const Vec2 paper = interiorPointOf(state.pattern, contact.moving);
  const double turn = isAtStart ? 0 : turned.motion.degrees;
  double degrees = amountAfter(turned, turn);
  if (contact.moment == CollisionMoment::Hinge) degrees = degrees > 0 ? 180 : -180;
  return noted(turned, contact, degrees, state.poseOf(contact.moving).apply(paper), true);
}

Collision described(const Turned& turned, const SweepReport& report) {
  const Contact contact{CollisionMoment::During, report.moving, report.resting};
  return noted(turned, contact, amountAfter(turned, report.degrees), report.place,
               report.verdict == SweepVerdict::Collides);
}

}  // namespace kiri
