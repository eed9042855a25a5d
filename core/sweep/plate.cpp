// SPDX-License-Identifier: MIT
#include "core/sweep/plate.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

/// How far a plate reaches on either side of the plane of another.
struct Reach {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
};

Reach reachOf(const Plate& a, const Plate& b) {
  Reach reach;
  for (const Vec3 p : a.points) {
    const double h = b.heightOf(p);
    reach.low = std::min(reach.low, h);
    reach.high = std::max(reach.high, h);
  }
  return reach;
}

/// Where a plate meets the plane of another: the stretch along `direction`, as coordinates and
/// points.
struct Stretch {
  double from = HUGE_VAL;
  double to = -HUGE_VAL;
  Vec3 start;
  Vec3 end;
};

Stretch stretchIn(const Plate& a, const Plate& b, Vec3 direction) {
  Stretch stretch;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Vec3 p = a.points[i];
    const Vec3 q = a.points[(i + 1) % a.points.size()];
    const double hp = b.heightOf(p);
    const double hq = b.heightOf(q);
    if ((hp > 0) == (hq > 0)) continue;
    const Vec3 meeting = p + (q - p) * (hp / (hp - hq));
    const double at = dot(direction, meeting);
    if (at < stretch.from) {
      stretch.from = at;
      stretch.start = meeting;
    }
    if (at > stretch.to) {
      stretch.to = at;
      stretch.end = meeting;
    }
  }
  return stretch;
}

double distanceOfSegments(Vec3 p, Vec3 p2, Vec3 q, Vec3 q2) {
  const Vec3 u = p2 - p;
  const Vec3 v = q2 - q;
  const Vec3 w = p - q;
  const double a = dot(u, u);
  const double b = dot(u, v);
  const double c = dot(v, v);
  const double d = dot(u, w);
  const double e = dot(v, w);
  const double det = a * c - b * b;
  double s = det > kParallel * a * c ? std::clamp((b * e - c * d) / det, 0.0, 1.0) : 0;
  const double t = c > 0 ? std::clamp((b * s + e) / c, 0.0, 1.0) : 0;
  s = a > 0 ? std::clamp((b * t - d) / a, 0.0, 1.0) : 0;
  return length(w + u * s - v * t);
}

/// How far two plates are apart along a unit direction; below 0 where they are not.
double gapAlong(const Plate& a, const Plate& b, Vec3 direction) {
  Reach ofA;
  Reach ofB;
  for (const Vec3 p : a.points) {
    const double at = dot(direction, p);
    ofA = {std::min(ofA.low, at), std::max(ofA.high, at)};
  }
  for (const Vec3 p : b.points) {
    const double at = dot(direction, p);
    ofB = {std::min(ofB.low, at), std::max(ofB.high, at)};
  }
  return std::max(ofA.low - ofB.high, ofB.low - ofA.high);
}

bool coversFoot(const Plate& plate, Vec3 p) {
  for (std::size_t i = 0; i < plate.points.size(); ++i) {
    const Vec3 a = plate.points[i];
    const Vec3 side = plate.points[(i + 1) % plate.points.size()] - a;
    if (dot(cross(plate.normal, side), p - a) < 0) return false;
  }
  return true;
}

/// The least distance of the corners of one plate from the inside of another.
double distanceOfCorners(const Plate& a, const Plate& b) {
  double least = HUGE_VAL;
  for (const Vec3 p : a.points) {
    const double height = std::abs(b.heightOf(p));
    if (height < least && coversFoot(b, p)) least = height;
  }
  return least;
}

double distanceOfSides(const Plate& a, const Plate& b) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Vec3 p = a.points[i];
    const Vec3 p2 = a.points[(i + 1) % a.points.size()];
    const Vec3 middle = (p + p2) / 2;
    const double half = distance(p, p2) / 2;
    if (distance(middle, b.middle) - half - b.radius >= least) continue;
    for (std::size_t j = 0; j < b.points.size(); ++j) {
      const Vec3 q = b.points[j];
      const Vec3 q2 = b.points[(j + 1) % b.points.size()];
      // No nearer than their balls: most sides are told apart without more.
      const double reach = least + half + distance(q, q2) / 2;
      const Vec3 between = (q + q2) / 2 - middle;
      if (dot(between, between) >= reach * reach) continue;
      least = std::min(least, distanceOfSegments(p, p2, q, q2));
    }
  }
  return least;
}

}  // namespace

Plate plateOf(const std::vector<Vec2>& convex, const Rigid& pose) {
  Plate plate;
  plate.points.reserve(convex.size());
  for (const Vec2 p : convex) {
    plate.points.push_back(pose.apply(p));
    plate.middle = plate.middle + plate.points.back();
  }
  plate.normal = pose.normal();
  plate.middle = plate.middle / static_cast<double>(convex.size());
  for (const Vec3 p : plate.points)
    plate.radius = std::max(plate.radius, distance(plate.middle, p));
  return plate;
}

double crossingDepth(const Plate& a, const Plate& b, Vec3& place) {
  if (distance(a.middle, b.middle) > a.radius + b.radius) return 0;
  const Reach ofA = reachOf(a, b);
  const Reach ofB = reachOf(b, a);
  const double deep = std::min({ofA.high, -ofA.low, ofB.high, -ofB.low});
  const Vec3 along = cross(a.normal, b.normal);
  if (deep <= 0 || length(along) == 0) return 0;
  const Vec3 direction = normalized(along);
  const Stretch inA = stretchIn(a, b, direction);
  const Stretch inB = stretchIn(b, a, direction);
  const bool startsInA = inA.from > inB.from;
  const bool endsInA = inA.to < inB.to;
  const double shared = std::min(inA.to, inB.to) - std::max(inA.from, inB.from);
  if (shared <= 0) return 0;
  place = ((startsInA ? inA.start : inB.start) + (endsInA ? inA.end : inB.end)) / 2;
  return std::min(deep, shared);
}

double distanceBetween(const Plate& a, const Plate& b, double enough) {
  const double apart = distance(a.middle, b.middle) - a.radius - b.radius;
  if (apart >= enough) return apart;
  // Most pairs are told apart by a plane between them, long before all sides are compared.
  for (const Vec3 direction : {a.normal, b.normal, b.middle - a.middle}) {
    const double span = length(direction);
    if (span == 0) continue;
    const double gap = gapAlong(a, b, direction / span);
    if (gap >= enough) return gap;
  }
  return std::min(distanceOfSides(a, b),
                  std::min(distanceOfCorners(a, b), distanceOfCorners(b, a)));
}

}  // namespace kiri
