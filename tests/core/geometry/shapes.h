// Random arcs and regions, and what brute force says about them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "core/geometry/region.h"

namespace kiri::test {

/// A seeded source of numbers.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(engine_);
  }
  int count(int low, int high) { return std::uniform_int_distribution<>(low, high)(engine_); }
  Vec2 point(double size = 100) { return {in(0, size), in(0, size)}; }
  Arc cubic() { return Arc::cubic(point(), point(), point(), point()); }
  Arc line() { return Arc::line(point(), point()); }

 private:
  std::mt19937 engine_;
};

inline std::vector<Vec2> polyline(const Arc& arc, int pieces) {
  std::vector<Vec2> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(pointAt(arc, static_cast<double>(i) / pieces));
  return points;
}

/// All loops as dense polygons.
inline std::vector<std::vector<Vec2>> polygons(const Region& region, int pieces) {
  std::vector<std::vector<Vec2>> result;
  for (const Loop& loop : region.loops) {
    std::vector<Vec2> polygon;
    for (const Arc& arc : loop) {
      const std::vector<Vec2> points = polyline(arc, arc.isCurved ? pieces : 1);
      polygon.insert(polygon.end(), points.begin(), points.end() - 1);
    }
    result.push_back(polygon);
  }
  return result;
}

/// Even-odd rule: counts crossings of the ray from p towards +x.
inline bool isInside(const std::vector<std::vector<Vec2>>& loops, Vec2 p) {
  bool inside = false;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i];
      const Vec2 b = loop[(i + 1) % loop.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  }
  return inside;
}

inline double distanceTo(Vec2 p, Vec2 a, Vec2 b) { return nearestOn(Arc::line(a, b), p).distance; }

inline double distanceTo(const std::vector<std::vector<Vec2>>& loops, Vec2 p) {
  double best = 1e300;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      best = std::min(best, distanceTo(p, loop[i], loop[(i + 1) % loop.size()]));
    }
  }
  return best;
}

inline Loop loopThrough(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(Arc::line(corners[i], corners[(i + 1) % corners.size()]));
  }
  return loop;
}

inline Loop turned(const Loop& loop) {
  Loop result;
  for (std::size_t i = loop.size(); i-- > 0;) result.push_back(reversed(loop[i]));
  return result;
}

inline Vec2 polar(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A star-shaped loop about `centre`, counter-clockwise; `bulge` 0 gives straight sides, else each
/// side is a cubic that strays by about that part of the radius.
inline Loop star(Random& random, Vec2 centre, double low, double high, int corners,
                 double bulge = 0) {
  std::vector<Vec2> p;
  for (int i = 0; i < corners; ++i) {
    p.push_back(centre + polar(random.in(low, high), (i + random.in(0, 0.6)) / corners));
  }
  Loop loop = loopThrough(p);
  if (bulge == 0) return loop;
  for (Arc& arc : loop) {
    // Controls stay in the sector between the two corners, so that the loop stays simple.
    const Vec2 a = arc.start - centre;
    const Vec2 b = arc.end - centre;
    const Vec2 c1 = (a * 2 + b) / 3 * (1 + random.in(-bulge, bulge));
    const Vec2 c2 = (a + b * 2) / 3 * (1 + random.in(-bulge, bulge));
    arc = Arc::cubic(arc.start, centre + c1, centre + c2, arc.end);
  }
  return loop;
}

/// A comb with `teeth` teeth, some slanted.
inline Loop comb(Random& random, int teeth) {
  std::vector<Vec2> p{{0, 0}, {100, 0}};
  for (int i = teeth; i-- > 0;) {
    const double left = 100.0 * i / teeth;
    const double width = 100.0 / teeth;
    p.push_back({left + width, random.in(40, 100)});
    if (random.count(0, 1) == 0) p.push_back({left + width * 0.6, random.in(40, 100)});
    p.push_back({left + width * 0.5, random.in(1, 30)});
  }
  p.push_back({0, 90});
  return loopThrough(p);
}

/// Corners on an ellipse: convex, from slender to round.
inline std::vector<Vec2> randomConvex(Random& random, int corners) {
  std::vector<double> turns(static_cast<std::size_t>(corners));
  for (double& t : turns) t = random.in(0, 1);
  std::sort(turns.begin(), turns.end());
  const Vec2 centre = random.point();
  const Vec2 u = polar(random.in(0.1, 60), random.in(0, 1));
  const Vec2 v = perpendicular(u) * random.in(0.01, 1);
  std::vector<Vec2> points;
  for (const double t : turns) {
    const Vec2 p = polar(1, t);
    points.push_back(centre + u * p.x + v * p.y);
  }
  return points;
}

}  // namespace kiri::test
