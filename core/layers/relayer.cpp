// SPDX-License-Identifier: MIT
#include "core/layers/relayer.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/arc_range.h"
#include "core/layers/hinge_checks.h"
#include "core/layers/hinge_conflicts.h"
#include "core/layers/merge_orders.h"
#include "core/layers/plane_view.h"

namespace kiri {
namespace {

/// How fast a point of the moving facets moves along a plane's normal, up to a positive factor:
/// linear in the point.
class Lift {
 public:
  Lift(const Motion& motion, Vec3 normal) : motion_(motion), normal_(normal) {}

  double at(Vec3 p) const {
    const double v = dot(normal_, cross(motion_.axis, p - motion_.point));
    return motion_.degrees < 0 ? -v : v;
  }

 private:
  const Motion& motion_;
  Vec3 normal_;
};

/// The line in plane coordinates where the lift is zero; the lift is positive on its left.
struct Divide {
  Vec2 point;
  Vec2 direction;
};

std::optional<Divide> divideOf(const Lift& lift, const Rigid& reference, double tolerance) {
  const double c = lift.at(reference.origin);
  const Vec2 gradient{lift.at(reference.origin + reference.x) - c,
                      lift.at(reference.origin + reference.y) - c};
  const double g2 = dot(gradient, gradient);
  if (g2 <= tolerance * tolerance) return std::nullopt;
  return Divide{gradient * (-c / g2), Vec2{gradient.y, -gradient.x}};
}

/// Whether a facet has paper where the lift is positive, and where it is negative.
struct Sides {
  bool isUp = false;
  bool isDown = false;
};

Sides sidesOf(const CreasePattern& pattern, FacetId facet, const Rigid& pose, const Lift& lift) {
  const double tol = pattern.tolerance.match();
  // The lift is linear over the paper: its value at the origin, and its growth along x and y.
  const double base = lift.at(pose.origin);
  const Vec2 growth{lift.at(pose.origin + pose.x) - base, lift.at(pose.origin + pose.y) - base};
  Sides sides;
  for (const EdgeUse use : pattern[facet].border) {
    const Range range = rangeAlong(arcOf(pattern, use), growth);
    sides.isUp = sides.isUp || base + range.high > tol;
    sides.isDown = sides.isDown || base + range.low < -tol;
  }
  return sides;
}

/// A layer-set parted into what moves and what rests, both bottom to top.
struct Parted {
  LayerSet moving;
  LayerSet fixed;
};

Parted part(const LayerSet& set, const std::vector<bool>& moves) {
  Parted result{{set.normal, {}, {}}, {set.normal, {}, {}}};
  for (const FacetId f : set.upward) {
    (moves[f.index] ? result.moving : result.fixed).upward.push_back(f);
  }
  for (const auto& pair : set.exceptions) {
    const bool first = moves[pair.first.index];
    if (first != moves[pair.second.index]) continue;
    (first ? result.moving : result.fixed).exceptions.insert(pair);
  }
  return result;
}

class Relayering {
 public:
  Relayering(const FoldedState& state, const std::vector<bool>& moves, const Motion& motion,
             const std::vector<Rigid>& after)
      : state_(state), moves_(moves), motion_(motion), after_(after) {}

  Relayered run() {
    std::vector<LayerSet> moving;
    std::vector<LayerSet> fixed;
    for (const LayerSet& set : state_.layers.sets()) {
      if (slides(set)) {
        fixed.push_back(set);
        continue;
      }
      Parted parted = part(set, moves_);
      if (!parted.moving.upward.empty() && !parted.fixed.upward.empty()) checkStart(set, parted);
      if (!parted.fixed.upward.empty()) fixed.push_back(std::move(parted.fixed));
      if (!parted.moving.upward.empty()) moving.push_back(carried(std::move(parted.moving)));
    }
    for (LayerSet& set : moving) {
      LayerSet* ground = nullptr;
      for (LayerSet& candidate : fixed) {
        if (ground == nullptr && isSamePlane(set, candidate)) ground = &candidate;
      }
      if (ground != nullptr) {
        land(std::move(set), *ground);
      } else {
        landed_.push_back(std::move(set));
      }
    }
    fixed.insert(fixed.end(), landed_.begin(), landed_.end());
    LayerOrder order(std::move(fixed));
    for (std::size_t set = 0; set < order.sets().size(); ++set) checkStanding(order, set);
    return {std::move(order), std::move(contacts_)};
  }

 private:
  /// A set across the axis turns within its plane: its layers neither rise nor sink.
  bool slides(const LayerSet& set) const {
    return length(cross(set.normal, motion_.axis)) <= kSamePlane;
  }

  /// The set with the normal that the motion gives it.
  LayerSet carried(LayerSet set) const {
    const FacetId first = set.upward.front();
    const bool agrees = dot(state_.poseOf(first).normal(), set.normal) > 0;
    const Vec3 normal = after_[first.index].normal();
    set.normal = agrees ? normal : -normal;
    return set;
  }

  bool isSamePlane(const LayerSet& a, const LayerSet& b) const {
    if (length(cross(a.normal, b.normal)) > kSamePlane) return false;
    const Rigid& pose = after_[a.upward.front().index];
    const Rigid& other = after_[b.upward.front().index];
    const CreasePattern& pattern = state_.pattern;
    const Vec2 p = pattern[startOf(pattern, pattern[a.upward.front()].border.front())];
    const Vec2 q = pattern[startOf(pattern, pattern[b.upward.front()].border.front())];
    return std::abs(dot(b.normal, pose.apply(p) - other.apply(q))) <= state_.tolerance().match();
  }

  void report(CollisionMoment moment, FacetId moving, FacetId fixed) {
    const auto count = std::count_if(contacts_.begin(), contacts_.end(),
                                     [&](const Contact& c) { return c.moment == moment; });
    if (static_cast<std::size_t>(count) < kMostContacts)
      contacts_.push_back({moment, moving, fixed});
  }

  /// A facet on its way up must not lie under a resting one, nor one on its way down above it.
  void checkStart(const LayerSet& set, const Parted& parted) {
    const Lift lift(motion_, set.normal);
    const Rigid& reference = state_.poseOf(set.upward.front());
    const auto divide = divideOf(lift, reference, kParallel);
    if (!divide) return;
    PlaneView view(state_.pattern, state_.poses, reference);
    std::vector<FacetId> moving[2];
    std::vector<FacetId> fixed[2];
    const auto sort = [&](const std::vector<FacetId>& facets, std::vector<FacetId>* into) {
      for (const FacetId f : facets) {
        const Sides sides = sidesOf(state_.pattern, f, state_.poseOf(f), lift);
        if (sides.isUp) into[0].push_back(f);
        if (sides.isDown) into[1].push_back(f);
      }
    };
    sort(parted.moving.upward, moving);
    sort(parted.fixed.upward, fixed);
    for (const int down : {0, 1}) {
      if (moving[down].empty() || fixed[down].empty()) continue;
      const Vec2 direction = down == 1 ? -divide->direction : divide->direction;
      checkStartOn(view, moving[down], fixed[down], down == 1, {divide->point, direction});
    }
  }

  void checkStartOn(PlaneView& view, const std::vector<FacetId>& moving,
                    const std::vector<FacetId>& fixed, bool goesDown, const Divide& side) {
    const LayerOrder& layers = state_.layers;
    const bool hasExceptions = !layers.sets()[layers.setOf(moving.front())].exceptions.empty();
    // Both lists run bottom to top: usually their ends already show that nothing is in the way.
    const FacetId worstMoving = goesDown ? moving.back() : moving.front();
    const FacetId worstFixed = goesDown ? fixed.front() : fixed.back();
    const bool isClear = (layers.rankOf(worstMoving) > layers.rankOf(worstFixed)) != goesDown;
    if (isClear && !hasExceptions) return;
    std::size_t found = 0;
    for (const FacetId m : moving) {
      for (const FacetId f : fixed) {
        if (layers.isAbove(m, f) != goesDown) continue;
        if (!view.doOverlapLeftOf(m, f, side.point, side.direction)) continue;
        report(CollisionMoment::Start, m, f);
        if (++found >= kMostContacts) return;
      }
    }
  }

  /// Merges a set that arrives into the one that lies in its plane already.
  void land(LayerSet set, LayerSet& ground) {
    if (dot(set.normal, ground.normal) < 0) {
      std::reverse(set.upward.begin(), set.upward.end());
      std::set<std::pair<FacetId, FacetId>> turned;
      for (const auto& [upper, lower] : set.exceptions) turned.insert({lower, upper});
      set.exceptions = std::move(turned);
      set.normal = ground.normal;
    }
    const Lift lift(motion_, ground.normal);
    std::vector<FacetId> fromAbove;
    std::vector<FacetId> fromBelow;
    bool doesStraddle = false;
    for (const FacetId f : set.upward) {
      const Sides sides = sidesOf(state_.pattern, f, after_[f.index], lift);
      doesStraddle = doesStraddle || (sides.isUp && sides.isDown);
      (sides.isUp ? fromBelow : fromAbove).push_back(f);
    }
    if (doesStraddle) {
      mergeStraddling(set, ground, lift);
      return;
    }
    std::vector<FacetId> merged = std::move(fromBelow);
    merged.insert(merged.end(), ground.upward.begin(), ground.upward.end());
    merged.insert(merged.end(), fromAbove.begin(), fromAbove.end());
    ground.upward = std::move(merged);
    ground.exceptions.insert(set.exceptions.begin(), set.exceptions.end());
  }

  /// Where paper stands on a plane, more is to be looked at than what lands on what: it must not
  /// pierce layers, nor other paper that stands or is folded along the same line.
  void checkStanding(const LayerOrder& order, std::size_t set) {
    const LayerSet& layers = order.sets()[set];
    if (!slides(layers) && standingOn(state_.pattern, after_, layers).empty()) return;
    const ConflictScope scope{moves_, kMostContacts};
    for (const HingeConflict& found : hingeConflicts(state_.pattern, after_, order, set, scope)) {
      FacetId moving;
      FacetId fixed;
      for (const FacetId f : {found.first[0], found.first[1], found.second[0], found.second[1]})
        (moves_[f.index] ? moving : fixed) = f;
      report(CollisionMoment::End, moving, fixed);
    }
  }

  /// The general case: relations pair by pair, then a list that fits them as far as a list can.
  void mergeStraddling(const LayerSet& set, LayerSet& ground, const Lift& lift) {
    const Rigid& reference = after_[ground.upward.front().index];
    const auto divide = divideOf(lift, reference, kParallel);
    KIRI_CHECK(divide.has_value(), "a facet straddles a line");
    PlaneView view(state_.pattern, after_, reference);
    std::vector<AbovePair> pairs = relationsWithin(set, view);
    const std::vector<AbovePair> resting = relationsWithin(ground, view);
    pairs.insert(pairs.end(), resting.begin(), resting.end());
    for (const FacetId m : set.upward) {
      for (const FacetId f : ground.upward) {
        // On the left of the divide the facet is on its way up, so it came from below.
        const bool isBelow = view.doOverlapLeftOf(m, f, divide->point, divide->direction);
        const bool isAbove = view.doOverlapLeftOf(m, f, divide->point, -divide->direction);
        if (isBelow && isAbove) report(CollisionMoment::End, m, f);
        if (isAbove) pairs.push_back({m, f});
        if (isBelow && !isAbove) pairs.push_back({f, m});
      }
    }
    ground = mergedOrder(ground, set, pairs);
  }

  const FoldedState& state_;
  const std::vector<bool>& moves_;
  const Motion& motion_;
  const std::vector<Rigid>& after_;
  std::vector<LayerSet> landed_;
  std::vector<Contact> contacts_;
};

}  // namespace

Relayered relayer(const FoldedState& state, const std::vector<bool>& moves, const Motion& motion,
                  const std::vector<Rigid>& after) {
  return Relayering(state, moves, motion, after).run();
}

}  // namespace kiri
