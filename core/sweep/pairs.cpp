// SPDX-License-Identifier: MIT
#include "core/sweep/pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "core/sweep/first_meeting.h"

namespace kiri {
namespace {

/// Whether all points stay on one side of a plane, or in it, during the whole motion. `waveOf`
/// gives the height of a point along the normal, as the one or the other turns.
template <class WaveOf>
bool stayBeside(const std::vector<Vec3>& points, double offset, const AxisFrame& frame,
                double slack, WaveOf waveOf) {
  bool isAbove = true;
  bool isBelow = true;
  for (const Vec3 p : points) {
    Wave wave = waveOf(p);
    wave.c -= offset;
    const WaveRange range = rangeOf(wave, frame);
    isAbove = isAbove && range.low >= -slack;
    isBelow = isBelow && range.high <= slack;
    if (!isAbove && !isBelow) return false;
  }
  return true;
}

/// Turning points and a plane that rests.
bool doPointsStayBeside(const std::vector<Vec3>& points, Vec3 normal, double offset,
                        const AxisFrame& frame, double slack) {
  return stayBeside(points, offset, frame, slack, [&](Vec3 p) { return Wave::of(p, normal); });
}

/// Resting points and a plane that turns.
bool doesPlaneStayBeside(const std::vector<Vec3>& points, Vec3 normal, double offset,
                         const AxisFrame& frame, double slack) {
  return stayBeside(points, offset, frame, slack, [&](Vec3 q) { return Wave::of(normal, q); });
}

double turnedForward(double angle) {
  angle = std::fmod(angle, kFullTurn);
  return angle < 0 ? angle + kFullTurn : angle;
}

/// Whether the azimuths that a body sweeps reach those of a resting one.
bool doAzimuthsMeet(const Body& m, const Body& f, double turn) {
  const double ahead = turnedForward(f.from - m.from + kAzimuthSlack);
  const double behind = turnedForward(m.from - f.from + kAzimuthSlack);
  return ahead <= m.width + turn + 2 * kAzimuthSlack || behind <= f.width + 2 * kAzimuthSlack;
}

Patch turned(const Patch& patch, Turn turn) {
  Patch result = patch;
  for (Vec3& p : result.points) p = turn.apply(p);
  result.normal = turn.apply(patch.normal);
  return result;
}

class PairSearch {
 public:
  PairSearch(const FoldedState& state, const std::vector<bool>& moves, const AxisFrame& frame,
             FirstFound& found)
      : state_(state),
        moves_(moves),
        frame_(frame),
        found_(found),
        touch_(state.tolerance().match()),
        radians_(frame.degrees * std::numbers::pi / 180),
        middle_(halfOf(frame)) {}

  bool canMeet(const Body& m, const Body& f) const {
    if (m.stance == Stance::Level && f.stance == Stance::Level) return false;
    // Pages are met elsewhere, but for those that both have the axis inside and cross there.
    const bool arePages = m.stance == Stance::Page && f.stance == Stance::Page;
    if (arePages && (m.width < kFullTurn || f.width < kFullTurn)) return false;
    if (m.zLow > f.zHigh + touch_ || f.zLow > m.zHigh + touch_) return false;
    if (m.rLow > f.rHigh + touch_ || f.rLow > m.rHigh + touch_) return false;
    if (!doAzimuthsMeet(m, f, radians_)) return false;
    const double slack = slackFor(m.goesOn || f.goesOn);
    return !doPointsStayBeside(m.hull, f.normal, f.offset, frame_, slack) &&
           !doesPlaneStayBeside(f.hull, m.normal, m.offset, frame_, slack);
  }

  void meet(const Body& m, const Body& f) {
    const KnownRoots known{isOnePlane(m, f, {}), isOnePlane(m, f, frame_.end)};
    const std::optional<Meeting3> near = firstOf(m, f, known, touch_);
    if (!near || found_.isSettledBefore(near->turn)) return;
    const std::optional<Meeting3> deep = firstOf(m, f, known, kDoubtful * touch_);
    const bool isCertain =
        deep && !isAtSlit(m.facet, near->turn.undo(near->place)) && !isAtSlit(f.facet, near->place);
    found_.add({m.facet, f.facet, near->turn, near->place, isCertain});
  }

 private:
  static Turn halfOf(const AxisFrame& frame) {
    const CosSin half = cosSinDegrees(frame.degrees / 2);
    return {half.cos, half.sin};
  }

  /// How far points may stand on the wrong side of a plane and still count as beside it. Where the
  /// paper goes on beyond what is looked at, they must be clear of it.
  double slackFor(bool goesOn) const {
    const double slack = state_.tolerance().length();
    return goesOn ? -slack : slack;
  }

  /// The turn that moves a point at this distance from the axis well beyond mere touching.
  Turn turnMoving(double radius) const {
    const double sine = 16 * touch_ / std::max(radius, 32 * touch_);
    const Turn turn{std::sqrt(1 - sine * sine), sine};
    return frame_.holds(turn) ? turn : middle_;
  }

  bool isOnePlane(const Body& m, const Body& f, Turn turn) const {
    return length(cross(turn.apply(m.normal), f.normal)) <= kSamePlane &&
           std::abs(dot(f.normal, turn.apply(m.hull.front())) - f.offset) <= touch_;
  }

  /// The first meeting of what lies deeper than `margin` in both facets.
  std::optional<Meeting3> firstOf(const Body& m, const Body& f, KnownRoots known, double margin) {
    const bool isTogether = known.atStart || known.atEnd;
    const MeetingSlack slack{touch_ / 8, isTogether ? touch_ / 4 : state_.tolerance().length()};
    // Where they touch at the start they cannot be seen to pass through each other before they have
    // moved a little.
    const Turn early = turnMoving(std::min(m.rHigh, f.rHigh));
    if (const auto place = pierced(m, f, margin, early)) return Meeting3{{}, *place};
    std::optional<Meeting3> first;
    for (const Patch& a : patches(m.facet, margin)) {
      for (const Patch& b : patches(f.facet, margin)) {
        if (!canMeet(a, b)) continue;
        const std::optional<Meeting3> next = firstMeeting(a, b, frame_, known, slack);
        if (next && (!first || next->turn.order() < first->turn.order())) first = next;
      }
    }
    if (first) return first;
    // What passes through half way, though nothing met until then, has done so all the time.
    if (const auto place = pierced(m, f, margin, middle_)) return Meeting3{{}, *place};
    return std::nullopt;
  }

  bool canMeet(const Patch& a, const Patch& b) const {
    if (a.zLow > b.zHigh + touch_ || b.zLow > a.zHigh + touch_) return false;
    const double slack = slackFor(a.goesOn || b.goesOn);
    return !doPointsStayBeside(a.points, b.normal, b.offset, frame_, slack) &&
           !doesPlaneStayBeside(b.points, a.normal, a.offset, frame_, slack);
  }

  /// Where the two pass through each other after a turn.
  std::optional<Vec3> pierced(const Body& m, const Body& f, double margin, Turn turn) {
    for (const Patch& a : patches(m.facet, margin)) {
      const Patch there = turned(a, turn);
      for (const Patch& b : patches(f.facet, margin)) {
        if (length(cross(there.normal, b.normal)) <= kSamePlane) continue;
        std::optional<Vec3> place = piercing(there, b, touch_ / 8);
        if (!place) place = piercing(b, there, touch_ / 8);
        if (place) return place;
      }
    }
    return std::nullopt;
  }

  const std::vector<Patch>& patches(FacetId facet, double margin) {
    auto& cache = margin > touch_ ? deep_ : near_;
    const auto [at, isNew] = cache.try_emplace(facet);
    if (isNew) at->second = insideOf(state_, moves_, frame_, facet, margin);
    return at->second;
  }

  bool isAtSlit(FacetId facet, Vec3 place) const {
    const Vec2 p = state_.poseOf(facet).pullBack(frame_.toModel(place));
    const std::vector<EdgeUse>& border = state_.pattern[facet].border;
    return std::any_of(border.begin(), border.end(), [&](EdgeUse use) {
      const Edge& edge = state_.pattern[use.edge];
      if (edge.left != edge.right || edge.kind == EdgeKind::Hinge) return false;
      return nearestOn(arcOf(state_.pattern, use), p).distance <= 2 * touch_;
    });
  }

  const FoldedState& state_;
  const std::vector<bool>& moves_;
  const AxisFrame& frame_;
  FirstFound& found_;
  double touch_;
  double radians_;
  Turn middle_;
  std::map<FacetId, std::vector<Patch>> near_;
  std::map<FacetId, std::vector<Patch>> deep_;
};

}  // namespace

void meetPairs(const FoldedState& state, const std::vector<bool>& moves,
               const std::vector<Body>& moving, const std::vector<Body>& resting,
               const AxisFrame& frame, FirstFound& found) {
  std::vector<const Body*> upward;
  for (const Body& body : resting) upward.push_back(&body);
  std::stable_sort(upward.begin(), upward.end(),
                   [](const Body* a, const Body* b) { return a->zLow < b->zLow; });
  PairSearch search(state, moves, frame, found);
  const double touch = state.tolerance().match();
  for (const Body& m : moving) {
    for (const Body* f : upward) {
      if (f->zLow > m.zHigh + touch) break;
      if (search.canMeet(m, *f)) search.meet(m, *f);
    }
  }
}

}  // namespace kiri
