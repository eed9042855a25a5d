// SPDX-License-Identifier: MIT
#include "core/fold/path_collisions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/layers/hinge_conflicts.h"
#include "core/sweep/path_check.h"
#include "core/sweep/pierced.h"

namespace kiri {
namespace {

constexpr double kMomentTurn = 4;  // degrees between two moments that are looked at

std::vector<double> momentsOf(const RigidPath& path, double degrees) {
  std::vector<double> moments;
  if (!path.isStraight()) {
    for (const RigidPath::Sample& sample : path.samples()) moments.push_back(sample.part);
    return moments;
  }
  const int count = std::max(1, static_cast<int>(std::ceil(degrees / kMomentTurn)));
  for (int i = 0; i < count; ++i) moments.push_back(path.reach() * i / count);
  moments.push_back(path.reach());
  return moments;
}

double amountIn(const FoldedState& state, FoldLineId line, const FoldAngles& angles) {
  for (std::size_t e = 0; e < angles.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.kind == EdgeKind::Hinge && edge.line == line) return edge.sign * angles[e];
  }
  return 0;
}

/// Where it happens, and between whom.
struct Met {
  CollisionMoment moment = CollisionMoment::During;
  FacetId first;
  FacetId second;
  Vec3 place;
  bool isCertain = true;
};

Collision told(const FoldedState& start, FoldLineId leading, double degrees, const Met& met) {
  Collision c;
  c.moment = met.moment;
  c.moving = interiorPointOf(start.pattern, met.first);
  c.fixed = interiorPointOf(start.pattern, met.second);
  c.degrees = degrees;
  c.place = met.place;
  c.isCertain = met.isCertain;
  c.message = "when \"" + start.lines[leading.index].name + "\" is at " + text(degrees) +
              " degrees and the creases joined to it follow, the paper at " + text(c.moving) +
              (met.isCertain ? " mm passes" : " mm may pass") + " through the paper at " +
              text(c.fixed) +
              " mm; move one fold line after the other, stop before that angle, or tear the paper "
              "there";
  return c;
}

}  // namespace

std::vector<Collision> collisionsOnTheWay(const Movement& movement, FoldLineId leading) {
  const FoldedState& start = *movement.start;
  const RigidPath& path = *std::get<Unfolding>(movement.how).path;
  const PosesAt posesAt = [&](double part) { return posesDuring(movement, part); };
  const PathReport report = checkPath(start, posesAt, momentsOf(path, degreesOf(movement)));
  if (report.verdict == SweepVerdict::Free) return {};
  const CollisionMoment moment = report.part > 0 ? CollisionMoment::During : CollisionMoment::Start;
  return {told(start, leading, amountIn(start, leading, path.at(report.part)),
               {moment, report.first, report.second, report.place,
                report.verdict == SweepVerdict::Collides})};
}

std::vector<Collision> collisionsAtTheEnd(const Movement& movement, FoldLineId leading,
                                          const FoldedState& end) {
  std::vector<Collision> found;
  const double degrees = amountIn(end, leading, anglesOf(end.pattern));
  const auto note = [&](FacetId a, FacetId b, Vec3 place, bool isCertain) {
    found.push_back(
        told(*movement.start, leading, degrees, {CollisionMoment::End, a, b, place, isCertain}));
  };
  if (const std::optional<Pierced> pierced = firstPierced(end))
    note(pierced->first, pierced->second, pierced->place, pierced->isCertain);
  for (std::size_t set = 0; set < end.layers.sets().size(); ++set) {
    for (const HingeConflict& c :
         hingeConflicts(end.pattern, end.poses, end.layers, set, {{}, 1})) {
      const Vec2 paper = interiorPointOf(end.pattern, c.first[0]);
      note(c.first[0], c.second[0], end.poseOf(c.first[0]).apply(paper), true);
    }
  }
  return found;
}

void notePathCollisions(const Movement& movement, FoldLineId leading, FoldedState& end) {
  for (const std::vector<Collision>& found :
       {collisionsOnTheWay(movement, leading), collisionsAtTheEnd(movement, leading, end)})
    end.collisions.insert(end.collisions.end(), found.begin(), found.end());
}

}  // namespace kiri
