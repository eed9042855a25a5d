// Turning about the axis of a motion, in the frame of that axis.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "core/geometry/rigid.h"
#include "core/layers/relayer.h"

namespace kiri {

/// A turn about the z axis as cosine and sine; directions of the plane compare without arcs.
struct Turn {
  double cos = 1;
  double sin = 0;

  Vec3 apply(Vec3 p) const { return {cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z}; }
  Vec3 undo(Vec3 p) const { return {cos * p.x + sin * p.y, cos * p.y - sin * p.x, p.z}; }
  Turn then(Turn next) const {
    return {cos * next.cos - sin * next.sin, sin * next.cos + cos * next.sin};
  }
  Turn inverse() const { return {cos, -sin}; }
  /// Grows from 0 (no turn) to 4 (a full one) as the angle does.
  double order() const {
    const double slope = sin / (std::abs(cos) + std::abs(sin));
    if (cos < 0) return 2 - slope;
    return sin < 0 ? 4 + slope : slope;
  }
  /// How far a point at distance 1 from the axis is between where this and the other turn put it.
  double chordTo(Turn other) const {
    const double c = cos - other.cos;
    const double s = sin - other.sin;
    return std::sqrt(c * c + s * s);
  }
};

/// The frame in which the axis is the z axis through the origin and the motion turns
/// counter-clockwise, by `degrees` > 0.
struct AxisFrame {
  Vec3 origin;
  Vec3 x;
  Vec3 y;
  Vec3 z;
  double degrees = 0;  ///< whole turn of the motion, at most 360
  Turn end;            ///< the whole turn

  explicit AxisFrame(const Motion& motion);
  Vec3 direction(Vec3 d) const { return {dot(d, x), dot(d, y), dot(d, z)}; }
  Vec3 toFrame(Vec3 p) const { return direction(p - origin); }
  Vec3 toModel(Vec3 p) const { return origin + x * p.x + y * p.y + z * p.z; }
  /// True for turns from none to the whole one.
  bool holds(Turn turn) const { return degrees >= 360 || turn.order() <= end.order(); }
};

/// a cos + b sin + c: how a condition on a turning point, plane or line depends on the turn.
/// Source: guide to algorithms 2.4.
struct Wave {
  double a = 0;
  double b = 0;
  double c = 0;

  /// The wave of dot(turned w, fixed).
  static Wave of(Vec3 w, Vec3 fixed) {
    return {w.x * fixed.x + w.y * fixed.y, w.x * fixed.y - w.y * fixed.x, w.z * fixed.z};
  }
  Wave operator-(const Wave& o) const { return {a - o.a, b - o.b, c - o.c}; }
  double at(Turn turn) const { return a * turn.cos + b * turn.sin + c; }
};

/// At most two turns.
struct Roots {
  std::array<Turn, 2> turns;
  int count = 0;
  void add(Turn turn) { turns[static_cast<std::size_t>(count++)] = turn; }
};

/// What is known of a wave beforehand: the pair that it belongs to lies in one plane at an end of
/// the motion, so that the wave is zero there but for rounding.
struct KnownRoots {
  bool atStart = false;
  bool atEnd = false;
};

/// Where a wave is zero, the known roots left out. None when it is zero everywhere but for
/// rounding.
Roots rootsOf(const Wave& wave, KnownRoots known, Turn end);

/// The lowest and highest value that a wave takes on the way from no turn to the whole one.
struct WaveRange {
  double low = 0;
  double high = 0;
};
WaveRange rangeOf(const Wave& wave, const AxisFrame& frame);

}  // namespace kiri
