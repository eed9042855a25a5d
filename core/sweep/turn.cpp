// SPDX-License-Identifier: MIT
#include "core/sweep/turn.h"

#include <algorithm>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

/// A unit vector across `z`, away from the coordinate axis that z is nearest to.
Vec3 someAcross(Vec3 z) {
  const double least = std::min({std::abs(z.x), std::abs(z.y), std::abs(z.z)});
  const Vec3 helper = std::abs(z.x) == least   ? Vec3{1, 0, 0}
                      : std::abs(z.y) == least ? Vec3{0, 1, 0}
                                               : Vec3{0, 0, 1};
  return normalized(helper - z * dot(helper, z));
}

Turn turnBy(double degrees) {
  const CosSin turn = cosSinDegrees(degrees);
  return {turn.cos, turn.sin};
}

/// The second root of a cos + b sin - a: tan(turn / 2) = b / a.
Turn otherRoot(double a, double b, double size2) {
  return {(a - b) * (a + b) / size2, 2 * a * b / size2};
}

}  // namespace

AxisFrame::AxisFrame(const Motion& motion)
    : origin(motion.point),
      x(someAcross(motion.axis)),
      z(motion.degrees < 0 ? -motion.axis : motion.axis),
      degrees(std::min(std::abs(motion.degrees), 360.0)),
      end(turnBy(degrees)) {
  y = cross(z, x);
}

Roots rootsOf(const Wave& wave, KnownRoots known, Turn end) {
  Roots roots;
  const double size2 = wave.a * wave.a + wave.b * wave.b;
  const double flat = kVanishing * std::abs(wave.c);
  if (size2 == 0 || size2 <= flat * flat) return roots;
  if (known.atStart) {
    roots.add(otherRoot(wave.a, wave.b, size2));
    return roots;
  }
  if (known.atEnd) {
    const Turn fromEnd =
        otherRoot(wave.a * end.cos + wave.b * end.sin, wave.b * end.cos - wave.a * end.sin, size2);
    roots.add(end.then(fromEnd));
    return roots;
  }
  const double size = std::sqrt(size2);
  const double square = (size - wave.c) * (size + wave.c);
  if (square < 0) return roots;
  const double w = std::sqrt(square);
  roots.add({(-wave.a * wave.c - wave.b * w) / size2, (-wave.b * wave.c + wave.a * w) / size2});
  roots.add({(-wave.a * wave.c + wave.b * w) / size2, (-wave.b * wave.c - wave.a * w) / size2});
  return roots;
}

WaveRange rangeOf(const Wave& wave, const AxisFrame& frame) {
  const double start = wave.a + wave.c;
  const double end = wave.at(frame.end);
  WaveRange range{std::min(start, end), std::max(start, end)};
  const double size = std::sqrt(wave.a * wave.a + wave.b * wave.b);
  if (size == 0) return range;
  const Turn crest{wave.a / size, wave.b / size};
  if (frame.holds(crest)) range.high = wave.c + size;
  if (frame.holds({-crest.cos, -crest.sin})) range.low = wave.c - size;
  return range;
}

}  // namespace kiri
