// Points, parts, areas and samples of arcs.
// SPDX-License-Identifier: MIT
#include "core/geometry/cubic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/check.h"
#include "core/geometry/bernstein.h"
#include "core/geometry/bounds.h"

namespace kiri {
namespace {

/// The symmetric three-variable form of the cubic: blossom(t, t, t) is the point at t.
Vec2 blossom(const Arc& arc, double r, double s, double t) {
  const Vec2 a = lerp(arc.start, arc.control1, r);
  const Vec2 b = lerp(arc.control1, arc.control2, r);
  const Vec2 c = lerp(arc.control2, arc.end, r);
  return lerp(lerp(a, b, s), lerp(b, c, s), t);
}

/// Five-point Gauss-Legendre quadrature of the speed between t0 and t1.
double gaussLength(const Arc& arc, double t0, double t1) {
  constexpr std::array<double, 3> kAt{0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> kWeight{0.5688888888888889, 0.4786286704993665,
                                          0.2369268850561891};
  const double middle = 0.5 * (t0 + t1);
  const double half = 0.5 * (t1 - t0);
  double sum = kWeight[0] * length(tangentAt(arc, middle));
  for (std::size_t i = 1; i < kAt.size(); ++i) {
    sum += kWeight[i] * (length(tangentAt(arc, middle - half * kAt[i])) +
                         length(tangentAt(arc, middle + half * kAt[i])));
  }
  return sum * half;
}

double adaptiveLength(const Arc& arc, double t0, double t1, double whole, double tolerance,
                      int depth) {
  const double middle = 0.5 * (t0 + t1);
  const double first = gaussLength(arc, t0, middle);
  const double second = gaussLength(arc, middle, t1);
  if (depth <= 0 || std::abs(first + second - whole) <= tolerance) return first + second;
  return adaptiveLength(arc, t0, middle, first, tolerance / 2, depth - 1) +
         adaptiveLength(arc, middle, t1, second, tolerance / 2, depth - 1);
}

Nearest nearestOnLine(const Arc& arc, Vec2 p) {
  const Vec2 along = arc.end - arc.start;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - arc.start, along) / square, 0.0, 1.0) : 0.0;
  return {t, distance(p, pointAt(arc, t))};
}

/// Bernstein coefficients of (B(t) - p) . B'(t), degree 5: zero where the distance to p is
/// stationary.
std::array<double, 6> stationaryDistance(const Arc& arc, Vec2 p) {
  const std::array<Vec2, 4> b{arc.start - p, arc.control1 - p, arc.control2 - p, arc.end - p};
  const std::array<Vec2, 3> d{b[1] - b[0], b[2] - b[1], b[3] - b[2]};
  constexpr std::array<double, 4> kThree{1, 3, 3, 1};
  constexpr std::array<double, 3> kTwo{1, 2, 1};
  constexpr std::array<double, 6> kFive{1, 5, 10, 10, 5, 1};
  std::array<double, 6> result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i + j] += kThree[i] * kTwo[j] / kFive[i + j] * dot(b[i], d[j]);
    }
  }
  return result;
}

}  // namespace

Vec2 pointAt(const Arc& arc, double t) {
  return arc.isCurved ? blossom(arc, t, t, t) : lerp(arc.start, arc.end, t);
}

Vec2 tangentAt(const Arc& arc, double t) {
  if (!arc.isCurved) return arc.end - arc.start;
  const Vec2 a = arc.control1 - arc.start;
  const Vec2 b = arc.control2 - arc.control1;
  const Vec2 c = arc.end - arc.control2;
  return lerp(lerp(a, b, t), lerp(b, c, t), t) * 3;
}

Vec2 startDirection(const Arc& arc) {
  if (arc.isCurved) {
    const Box box = boundsOf(arc);
    const double nothing = kVanishing * distance(box.low, box.high);
    for (const Vec2 d : {arc.control1 - arc.start, arc.control2 - arc.start}) {
      if (length(d) > nothing) return normalized(d);
    }
  }
  const Vec2 d = arc.end - arc.start;
  return d == Vec2{} ? Vec2{} : normalized(d);
}

Arc part(const Arc& arc, double t0, double t1) {
  if (t0 == 0 && t1 == 1) return arc;
  if (!arc.isCurved) return Arc::line(pointAt(arc, t0), pointAt(arc, t1));
  return Arc::cubic(blossom(arc, t0, t0, t0), blossom(arc, t0, t0, t1), blossom(arc, t0, t1, t1),
                    blossom(arc, t1, t1, t1));
}

Arc reversed(const Arc& arc) {
  return arc.isCurved ? Arc::cubic(arc.end, arc.control2, arc.control1, arc.start)
                      : Arc::line(arc.end, arc.start);
}

Box boundsOf(const Arc& arc) {
  Box box = joined(Box{arc.start, arc.start}, arc.end);
  if (!arc.isCurved) return box;
  for (const Vec2 p : {arc.control1, arc.control2}) box = joined(box, p);
  return box;
}

double doubleArea(const Arc& arc) {
  if (!arc.isCurved) return cross(arc.start, arc.end);
  const Vec2 a = arc.start;
  const Vec2 b = arc.control1;
  const Vec2 c = arc.control2;
  const Vec2 d = arc.end;
  return (6 * (cross(a, b) + cross(c, d)) + 3 * (cross(a, c) + cross(b, c) + cross(b, d)) +
          cross(a, d)) /
         10;
}

double lengthOf(const Arc& arc, double tolerance) {
  if (!arc.isCurved) return distance(arc.start, arc.end);
  constexpr int kDepth = 16;
  return adaptiveLength(arc, 0, 1, gaussLength(arc, 0, 1), tolerance, kDepth);
}

std::vector<double> flatteningParameters(const Arc& arc, double chordError) {
  if (!arc.isCurved) return {0, 1};
  KIRI_CHECK(chordError > 0, "the distance of a polyline from its curve is above zero");
  const double bend = std::max(length(arc.start - arc.control1 * 2 + arc.control2),
                               length(arc.control1 - arc.control2 * 2 + arc.end));
  // The second derivative is at most 6 bend, so n equal steps stay within 6 bend / (8 n^2) of the
  // arc. The slight shrinking keeps rounding (a moved or mirrored arc) from tipping a whole number
  // over to the next.
  constexpr double kMostPieces = 4096;
  const double wanted = std::ceil(std::sqrt(0.75 * bend / chordError) * (1 - kParallel));
  const auto count = static_cast<std::size_t>(std::clamp(wanted, 1.0, kMostPieces));
  std::vector<double> parameters(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    parameters[i] = static_cast<double>(i) / static_cast<double>(count);
  }
  return parameters;
}

Nearest nearestOn(const Arc& arc, Vec2 p) {
  if (!arc.isCurved) return nearestOnLine(arc, p);
  Nearest best{0, distance(p, arc.start)};
  const auto consider = [&](double t, Vec2 q) {
    const double d = distance(p, q);
    if (d < best.distance) best = {t, d};
  };
  consider(1, arc.end);
  const std::array<double, 6> slope = stationaryDistance(arc, p);
  for (const double t : bernstein::signChanges(slope)) consider(t, pointAt(arc, t));
  return best;
}

}  // namespace kiri
