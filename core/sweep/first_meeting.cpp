// SPDX-License-Identifier: MIT
#include "core/sweep/first_meeting.h"

#include <algorithm>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

double radiusOf(Vec3 p) { return std::sqrt(p.x * p.x + p.y * p.y); }

struct Side {
  Vec3 start;
  Vec3 along;
};

Side sideOf(const Patch& patch, std::size_t i) {
  const Vec3 start = patch.points[i];
  return {start, patch.points[i + 1 < patch.points.size() ? i + 1 : 0] - start};
}

/// Where two segments that cross, or nearly, do so.
std::optional<Vec3> crossingOf(const Side& a, const Side& b, double reach) {
  const Vec3 across = cross(a.along, b.along);
  const double across2 = dot(across, across);
  const double a2 = dot(a.along, a.along);
  const double b2 = dot(b.along, b.along);
  if (across2 <= kParallel * kParallel * a2 * b2) return std::nullopt;
  const Vec3 between = b.start - a.start;
  const double t = dot(cross(between, b.along), across) / across2;
  const double u = dot(cross(between, a.along), across) / across2;
  const double tSlack = reach / std::sqrt(a2);
  const double uSlack = reach / std::sqrt(b2);
  if (t < -tSlack || t > 1 + tSlack || u < -uSlack || u > 1 + uSlack) return std::nullopt;
  return a.start + a.along * t;
}

class Search {
 public:
  Search(const AxisFrame& frame, KnownRoots known, MeetingSlack slack)
      : frame_(frame), known_(known), slack_(slack) {}

  std::optional<Meeting3> run(const Patch& moving, const Patch& resting) {
    for (const Vec3 p : moving.points) cornerOfMoving(p, resting);
    for (const Vec3 q : resting.points) cornerOfResting(q, moving);
    for (std::size_t i = 0; i < moving.points.size(); ++i) {
      const Side a = sideOf(moving, i);
      const Vec3 moment = cross(a.start, a.along);
      for (std::size_t j = 0; j < resting.points.size(); ++j) sides(a, moment, sideOf(resting, j));
    }
    return first_;
  }

 private:
  void cornerOfMoving(Vec3 p, const Patch& resting) {
    Wave wave = Wave::of(p, resting.normal);
    wave.c -= resting.offset;
    const Roots roots = rootsOf(wave, known_, frame_.end);
    for (int i = 0; i < roots.count; ++i) {
      const Turn turn = roots.turns[static_cast<std::size_t>(i)];
      const Vec3 place = turn.apply(p);
      if (isEarlier(turn, place) && resting.covers(place, slack_.reach)) first_ = {turn, place};
    }
  }

  void cornerOfResting(Vec3 q, const Patch& moving) {
    Wave wave = Wave::of(moving.normal, q);
    wave.c -= moving.offset;
    const Roots roots = rootsOf(wave, known_, frame_.end);
    for (int i = 0; i < roots.count; ++i) {
      const Turn turn = roots.turns[static_cast<std::size_t>(i)];
      if (isEarlier(turn, q) && moving.covers(turn.undo(q), slack_.reach)) first_ = {turn, q};
    }
  }

  void sides(const Side& a, Vec3 moment, const Side& b) {
    const Wave wave = Wave::of(a.along, cross(b.along, b.start)) - Wave::of(moment, b.along);
    const Roots roots = rootsOf(wave, known_, frame_.end);
    for (int i = 0; i < roots.count; ++i) {
      const Turn turn = roots.turns[static_cast<std::size_t>(i)];
      if (!isInside(turn)) continue;
      const Side turned{turn.apply(a.start), turn.apply(a.along)};
      const std::optional<Vec3> place = crossingOf(turned, b, slack_.reach);
      if (place && isEarlier(turn, *place)) first_ = {turn, *place};
    }
  }

  bool isInside(Turn turn) const {
    return frame_.holds(turn) && (!first_ || turn.order() < first_->turn.order());
  }

  bool isEarlier(Turn turn, Vec3 place) const {
    if (!isInside(turn)) return false;
    const double radius = radiusOf(place);
    return radius * turn.chordTo({}) > slack_.ends &&
           radius * turn.chordTo(frame_.end) > slack_.ends;
  }

  const AxisFrame& frame_;
  KnownRoots known_;
  MeetingSlack slack_;
  std::optional<Meeting3> first_;
};

}  // namespace

std::optional<Meeting3> firstMeeting(const Patch& moving, const Patch& resting,
                                     const AxisFrame& frame, KnownRoots known, MeetingSlack slack) {
  if (moving.zLow > resting.zHigh + slack.reach || resting.zLow > moving.zHigh + slack.reach)
    return std::nullopt;
  return Search(frame, known, slack).run(moving, resting);
}

}  // namespace kiri
