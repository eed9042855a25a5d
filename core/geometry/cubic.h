// One cubic Bezier piece, and what a cut needs to know of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/tolerance.h"

namespace kiri {

/// An edge of a region: a straight segment, or a cubic Bezier curve, from `start` to `end`,
/// parameter 0 to 1. A straight arc ignores its controls.
struct Arc {
  Vec2 start;
  Vec2 end;
  bool isCurved = false;
  Vec2 control1 = {};
  Vec2 control2 = {};

  static Arc line(Vec2 from, Vec2 to) { return {from, to, false, {}, {}}; }
  static Arc cubic(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3) { return {p0, p3, true, p1, p2}; }
  constexpr bool operator==(const Arc&) const = default;
};

struct Box {
  Vec2 low;
  Vec2 high;
};

/// The least box that holds both.
constexpr Box joined(const Box& a, const Box& b) {
  return {{a.low.x < b.low.x ? a.low.x : b.low.x, a.low.y < b.low.y ? a.low.y : b.low.y},
          {a.high.x > b.high.x ? a.high.x : b.high.x, a.high.y > b.high.y ? a.high.y : b.high.y}};
}
/// True when the boxes overlap or lie no farther than `margin` apart.
constexpr bool areNear(const Box& a, const Box& b, double margin) {
  return a.low.x <= b.high.x + margin && b.low.x <= a.high.x + margin &&
         a.low.y <= b.high.y + margin && b.low.y <= a.high.y + margin;
}

Vec2 pointAt(const Arc& arc, double t);
/// First derivative by t (for a straight arc: end - start).
Vec2 tangentAt(const Arc& arc, double t);
/// A unit direction in which the arc leaves its start; never zero unless the arc is a point.
Vec2 startDirection(const Arc& arc);
/// The part from t0 to t1, 0 <= t0 < t1 <= 1, exact up to rounding (de Casteljau).
Arc part(const Arc& arc, double t0, double t1);
/// The same points, run through backwards.
Arc reversed(const Arc& arc);
/// Box of the control points: holds the arc.
Box boundsOf(const Arc& arc);
/// Twice the signed area between the arc and the origin, exact for both kinds (Green's theorem).
double doubleArea(const Arc& arc);
/// Length of the arc, to about `tolerance`.
double lengthOf(const Arc& arc, double tolerance);
/// Parameters 0 = t_0 < ... < t_n = 1 whose chords stay within `chordError` of the arc. A straight
/// arc: {0, 1}. Depends only on the shape: a mirrored or moved arc is sampled at the same
/// parameters.
std::vector<double> flatteningParameters(const Arc& arc, double chordError);
/// Parameter of the point of the arc nearest to `p`, and the distance.
struct Nearest {
  double t = 0;
  double distance = 0;
};
Nearest nearestOn(const Arc& arc, Vec2 p);

/// A place where two arcs meet: parameters on the first and on the second.
struct Meeting {
  double t = 0;
  double u = 0;
};

/// Where arc `a` crosses or touches arc `b`, sorted by t, each place once; ends within
/// `tolerance.length()` of the other arc are found with their parameter exactly 0 or 1. Stretches
/// along which the arcs coincide give their two ends. Any mix of straight and curved arcs.
std::vector<Meeting> meetings(const Arc& a, const Arc& b, const Tolerance& tolerance);

/// Parameters at which the arc crosses or touches the infinite line through `point` along
/// `direction`, sorted. An arc that lies in the line gives none.
std::vector<double> lineMeetings(const Arc& arc, Vec2 point, Vec2 direction,
                                 const Tolerance& tolerance);

}  // namespace kiri
