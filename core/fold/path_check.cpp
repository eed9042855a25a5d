// SPDX-License-Identifier: MIT
#include "core/fold/path_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/layers/hinge_conflicts.h"
#include "core/layers/order_by_height.h"
#include "core/layers/plane_view.h"
#include "core/sweep/pierced.h"

namespace kiri {
namespace {

constexpr double kDegreesApart = 2;
constexpr int kMostMoments = 180;

double amountIn(const FoldedState& state, FoldLineId line) {
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge && edge.line == line) return edge.sign * edge.angle;
  }
  return 0;
}

class PathCheck {
 public:
  PathCheck(const Movement& movement, FoldLineId leading, const FoldedState& end)
      : movement_(movement), start_(*movement.start), leading_(leading), end_(end) {}

  std::vector<Collision> run() {
    leave();
    if (found_.empty()) travel();
    arrive();
    return std::move(found_);
  }

 private:
  int moments() const {
    const double count = std::ceil(degreesOf(movement_) / kDegreesApart);
    return static_cast<int>(std::clamp(count, 2.0, 1.0 * kMostMoments));
  }

  void note(CollisionMoment moment, FacetId a, FacetId b, const FoldedState& when, Vec3 place,
            bool isCertain) {
    Collision c;
    c.moment = moment;
    c.moving = interiorPointOf(start_.pattern, a);
    c.fixed = interiorPointOf(start_.pattern, b);
    c.degrees = amountIn(when, leading_);
    c.place = place;
    c.isCertain = isCertain;
    c.message = "when \"" + start_.lines[leading_.index].name + "\" is at " + text(c.degrees) +
                " degrees and the creases joined to it follow, the paper at " + text(c.moving) +
                (isCertain ? " mm passes" : " mm may pass") + " through the paper at " +
                text(c.fixed) +
                " mm; fold fewer layers, stop before that angle, or tear the paper there";
    found_.push_back(std::move(c));
  }

  /// Layers that lie on each other must part as their order says.
  void leave() {
    const FoldedState next = posedDuring(movement_, 1.0 / kMostMoments);
    const LayerOrder parting = orderByHeight(start_, start_.poses, next.poses);
    for (const LayerSet& set : start_.layers.sets()) {
      PlaneView view(start_.pattern, start_.poses, start_.poseOf(set.upward.front()));
      for (std::size_t i = 0; i < set.upward.size(); ++i) {
        for (std::size_t j = i + 1; j < set.upward.size(); ++j) {
          const FacetId a = set.upward[i];
          const FacetId b = set.upward[j];
          if (!parting.areCoplanar(a, b) || isKept(parting, a, b) || !view.doOverlap(a, b))
            continue;
          const Vec2 paper = interiorPointOf(start_.pattern, a);
          note(CollisionMoment::Start, a, b, start_, start_.poseOf(a).apply(paper), true);
          return;
        }
      }
    }
  }

  bool isKept(const LayerOrder& parting, FacetId a, FacetId b) const {
    const Vec3 before = start_.layers.sets()[start_.layers.setOf(a)].normal;
    const Vec3 after = parting.sets()[parting.setOf(a)].normal;
    return (start_.layers.isAbove(a, b) == parting.isAbove(a, b)) == (dot(before, after) > 0);
  }

  void travel() {
    const int count = moments();
    for (int k = 1; k < count; ++k) {
      const FoldedState now = posedDuring(movement_, static_cast<double>(k) / count);
      const std::optional<Pierced> pierced = firstPierced(now);
      if (!pierced) continue;
      note(CollisionMoment::During, pierced->first, pierced->second, now, pierced->place,
           pierced->isCertain);
      if (pierced->isCertain) return;
    }
  }

  void arrive() {
    if (const std::optional<Pierced> pierced = firstPierced(end_)) {
      note(CollisionMoment::End, pierced->first, pierced->second, end_, pierced->place,
           pierced->isCertain);
    }
    for (std::size_t set = 0; set < end_.layers.sets().size(); ++set) {
      for (const HingeConflict& c :
           hingeConflicts(end_.pattern, end_.poses, end_.layers, set, {{}, 1})) {
        const Vec2 paper = interiorPointOf(end_.pattern, c.first[0]);
        note(CollisionMoment::End, c.first[0], c.second[0], end_,
             end_.poseOf(c.first[0]).apply(paper), true);
      }
    }
  }

  const Movement& movement_;
  const FoldedState& start_;
  FoldLineId leading_;
  const FoldedState& end_;
  std::vector<Collision> found_;
};

}  // namespace

void notePathCollisions(const Movement& movement, FoldLineId leading, FoldedState& end) {
  std::vector<Collision> found = PathCheck(movement, leading, end).run();
  end.collisions.insert(end.collisions.end(), found.begin(), found.end());
}

}  // namespace kiri
