// Rotations whose bits do not depend on the platform's mathematics library.
// SPDX-License-Identifier: MIT
#include "core/geometry/rigid.h"

#include <cmath>
#include <numbers>

#include "core/base/check.h"
#include "core/geometry/exact_product.h"

namespace kiri {
namespace {

// pi / 180 as a double, and what that misses of the true value.
constexpr double kRadian = 0x1.1df46a2529d39p-6;
constexpr double kRadianRest = 0x1.5c1d8becdd291p-62;
constexpr double kDegree = 180.0 / std::numbers::pi;

/// Cosine and sine for 0 <= degrees < 45 by their series; the first term left out is below 2^-60.
CosSin cosSinSmall(double degrees) {
  const ExactProduct turn = exactProduct(degrees, kRadian);
  const double x = turn.high;
  const double rest = turn.low + degrees * kRadianRest;
  const double z = x * x;
  double sine = 0;    // sin x = x (1 + sine)
  double cosine = 0;  // cos x = 1 - z / 2 (1 + cosine)
  for (int n = 17; n >= 3; n -= 2) {
    sine = -z / (n * (n - 1)) * (1.0 + sine);
    cosine = -z / ((n + 1) * n) * (1.0 + cosine);
  }
  const double half = 0.5 * z;
  const double nearly = 1.0 - half;
  return {nearly + (((1.0 - nearly) - half) - (half * cosine + x * rest)),
          x + (x * sine + rest * nearly)};
}

/// For 0 <= degrees <= 360, after reduction to the first octant.
CosSin cosSinReduced(double degrees) {
  const double quarter = std::floor(degrees / 90 + 0.5);
  const double rest = degrees - 90 * quarter;
  CosSin small;
  if (std::abs(rest) == 45) {
    small = {std::sqrt(0.5), std::sqrt(0.5)};
  } else {
    small = cosSinSmall(std::abs(rest));
  }
  if (rest < 0) small.sin = -small.sin;
  switch (static_cast<int>(quarter) % 4) {
    case 0:
      return small;
    case 1:
      return {-small.sin, small.cos};
    case 2:
      return {-small.cos, -small.sin};
    default:
      return {small.sin, -small.cos};
  }
}

/// Angle in degrees of the direction (1, slope), 0 < slope < 1.
double smallAngle(double slope) {
  double angle = slope * (45 + 15.66 * (1 - slope));  // within 0.25 degrees
  for (int i = 0; i < 3; ++i) {
    const CosSin at = cosSinDegrees(angle);
    const double q =
        (at.cos * slope - at.sin) / (at.cos + at.sin * slope);  // tan of what is missing
    angle += kDegree * (q - q * q * q / 3);
  }
  return angle;
}

/// Takes the sign off zeros, so that equal poses have equal bytes.
Vec3 plainZeros(Vec3 v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

}  // namespace

CosSin cosSinDegrees(double degrees) {
  KIRI_CHECK(std::isfinite(degrees), "an angle is a finite number of degrees");
  const double size = std::fmod(std::abs(degrees), 360.0);  // exact
  CosSin result = cosSinReduced(size);
  if (degrees < 0) result.sin = -result.sin;
  return {result.cos + 0.0, result.sin + 0.0};
}

double angleDegrees(double x, double y) {
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  double angle = 0;  // of (ax, ay)
  if (ax == ay) {
    angle = ax == 0 ? 0 : 45;
  } else if (ay == 0) {
    angle = 0;
  } else if (ax == 0) {
    angle = 90;
  } else {
    angle = ay < ax ? smallAngle(ay / ax) : 90 - smallAngle(ax / ay);
  }
  if (x < 0) angle = 180 - angle;
  return y < 0 && angle < 180 ? -angle : angle;
}

Rigid compose(const Rigid& a, const Rigid& b) {
  return {plainZeros(a.direction(b.x)), plainZeros(a.direction(b.y)), plainZeros(a.direction(b.z)),
          plainZeros(a.apply(b.origin))};
}

Rigid rotationAbout(Vec3 point, Vec3 unitAxis, double degrees) {
  const CosSin turn = cosSinDegrees(degrees);
  if (turn.cos == 1) return {};
  Rigid r;
  if (turn.cos == -1) {  // reflection in the line: 2 u u^T / (u u) - 1
    const Vec3 u = unitAxis;
    const Vec3 twice = u * (2 / dot(u, u));
    r.x = twice * u.x - Vec3{1, 0, 0};
    r.y = twice * u.y - Vec3{0, 1, 0};
    r.z = twice * u.z - Vec3{0, 0, 1};
  } else {
    const Vec3 u = normalized(unitAxis);  // once more: its rounding would stretch the paper
    const Vec3 v = u * (1 - turn.cos);
    const Vec3 w = u * turn.sin;
    r.x = v * u.x + Vec3{turn.cos, w.z, -w.y};
    r.y = v * u.y + Vec3{-w.z, turn.cos, w.x};
    r.z = v * u.z + Vec3{w.y, -w.x, turn.cos};
  }
  r = {plainZeros(r.x), plainZeros(r.y), plainZeros(r.z), {}};
  r.origin = plainZeros(point - r.direction(point));
  return r;
}

Rigid translation(Vec3 by) {
  Rigid r;
  r.origin = by;
  return r;
}

}  // namespace kiri
