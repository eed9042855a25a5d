// SPDX-License-Identifier: MIT
#include "core/sweep/facet_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/convex.h"

namespace kiri {
namespace {

/// atan2 within 0.004 radians: enough for the broad phase.
double roughAzimuth(double x, double y) {
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const double t = std::min(ax, ay) / std::max(ax, ay);
  double angle = t * (1.0584 - 0.273 * t);
  if (ay > ax) angle = std::numbers::pi / 2 - angle;
  if (x < 0) angle = std::numbers::pi - angle;
  return y < 0 ? -angle : angle;
}

double wrapped(double angle) {
  if (angle > std::numbers::pi) return angle - kFullTurn;
  if (angle < -std::numbers::pi) return angle + kFullTurn;
  return angle;
}

/// Squared distance of the axis from a segment, both seen along the axis.
double nearness2(Vec3 a, Vec3 b) {
  const Vec2 p{a.x, a.y};
  const Vec2 d{b.x - a.x, b.y - a.y};
  const double d2 = dot(d, d);
  const double t = d2 == 0 ? 0 : std::clamp(-dot(p, d) / d2, 0.0, 1.0);
  const Vec2 foot = p + d * t;
  return dot(foot, foot);
}

/// Which azimuths a loop of points covers, walking along it.
class AzimuthWalk {
 public:
  explicit AzimuthWalk(double axisRadius) : r2_(axisRadius * axisRadius) {}

  void add(Vec3 p) {
    if (p.x * p.x + p.y * p.y <= r2_) {
      return;
    }
    const double azimuth = roughAzimuth(p.x, p.y);
    if (!hasAny_) {
      first_ = last_ = azimuth;
      low_ = high_ = at_ = azimuth;
      hasAny_ = true;
      return;
    }
    step(azimuth);
  }

  void writeTo(Body& body) {
    if (!hasAny_) {
      body.width = kFullTurn;
      return;
    }
    step(first_);
    const bool isAround = std::abs(at_ - first_) > 1;
    body.from = low_;
    body.width = high_ - low_;
    if (isAround || hasLeap_) body.width = kFullTurn;
  }

 private:
  void step(double azimuth) {
    const double by = wrapped(azimuth - last_);
    // Nearly half way around: which way is not to be told.
    hasLeap_ = hasLeap_ || std::abs(by) > std::numbers::pi - 4 * kAzimuthSlack;
    at_ += by;
    low_ = std::min(low_, at_);
    high_ = std::max(high_, at_);
    last_ = azimuth;
  }

  double r2_;
  bool hasAny_ = false;
  bool hasLeap_ = false;
  double first_ = 0;
  double last_ = 0;
  double at_ = 0;
  double low_ = 0;
  double high_ = 0;
};

Stance stanceOf(Vec3 normal, double offset, const Tolerance& tolerance) {
  if (length(Vec2{normal.x, normal.y}) <= kSamePlane) return Stance::Level;
  const bool isPage = std::abs(normal.z) <= kSamePlane && std::abs(offset) <= tolerance.match();
  return isPage ? Stance::Page : Stance::Slanting;
}

/// Whether the paper goes on straight across an edge, and on both sides moves alike.
bool isStraightOn(const Edge& edge, const std::vector<bool>& moves) {
  return edge.kind == EdgeKind::Hinge && edge.angle == 0 &&
         moves[edge.left.index] == moves[edge.right.index];
}

/// Whether a corner at the axis is less than half a turn wide, so that a walk past it goes the
/// short way round.
bool isConvexCorner(const Body& body, std::size_t i) {
  const std::size_t n = body.hull.size();
  const Vec3 in = body.hull[i] - body.hull[(i + n - 1) % n];
  const Vec3 out = body.hull[(i + 1) % n] - body.hull[i];
  return dot(body.normal, cross(in, out)) > 0;
}

/// Sets what a body can reach from its hull. Curves may come nearer to the axis than the lines
/// between their controls do.
void measure(Body& body, bool isCurved, double axisRadius) {
  AzimuthWalk walk(axisRadius);
  double near2 = HUGE_VAL;
  double far2 = 0;
  bool hasBay = false;
  body.zLow = HUGE_VAL;
  body.zHigh = -HUGE_VAL;
  for (std::size_t i = 0; i < body.hull.size(); ++i) {
    const Vec3 p = body.hull[i];
    walk.add(p);
    body.zLow = std::min(body.zLow, p.z);
    body.zHigh = std::max(body.zHigh, p.z);
    const double r2 = p.x * p.x + p.y * p.y;
    far2 = std::max(far2, r2);
    near2 = std::min(near2, nearness2(p, body.hull[i + 1 < body.hull.size() ? i + 1 : 0]));
    if (r2 <= axisRadius * axisRadius) hasBay = hasBay || !isConvexCorner(body, i);
  }
  walk.writeTo(body);
  if (hasBay) body.width = kFullTurn;
  body.rHigh = std::sqrt(far2);
  body.rLow = isCurved || body.width >= kFullTurn ? 0 : std::sqrt(near2);
}

}  // namespace

bool Patch::covers(Vec3 p, double slack) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 a = points[i];
    const Vec3 side = points[i + 1 < points.size() ? i + 1 : 0] - a;
    const double beyond = dot(cross(normal, side), p - a);
    if (beyond < 0 && beyond * beyond > slack * slack * dot(side, side)) return false;
  }
  return true;
}

std::optional<Vec3> piercing(const Patch& a, const Patch& b, double reach) {
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Vec3 p = a.points[i];
    const Vec3 q = a.points[i + 1 < a.points.size() ? i + 1 : 0];
    const double hp = b.heightOf(p);
    const double hq = b.heightOf(q);
    if ((hp < 0) == (hq < 0)) continue;
    const Vec3 place = p + (q - p) * (hp / (hp - hq));
    if (b.covers(place, reach)) return place;
  }
  return std::nullopt;
}

Body bodyOf(const FoldedState& state, const std::vector<bool>& moves, const AxisFrame& frame,
            FacetId facet) {
  const CreasePattern& pattern = state.pattern;
  const Rigid& pose = state.poseOf(facet);
  const Rigid placed{frame.direction(pose.x), frame.direction(pose.y), frame.direction(pose.z),
                     frame.toFrame(pose.origin)};
  Body body;
  body.facet = facet;
  body.normal = placed.z;
  body.offset = dot(placed.z, placed.origin);
  body.stance = stanceOf(body.normal, body.offset, pattern.tolerance);
  const Facet& f = pattern[facet];
  const std::size_t outer = f.holeStarts.empty() ? f.border.size() : f.holeStarts.front();
  body.hull.reserve(outer);
  for (std::size_t i = 0; i < outer; ++i) {
    const Arc arc = arcOf(pattern, f.border[i]);
    body.hull.push_back(placed.apply(arc.start));
    if (!arc.isCurved) continue;
    body.hull.push_back(placed.apply(arc.control1));
    body.hull.push_back(placed.apply(arc.control2));
  }
  body.goesOn = std::any_of(f.border.begin(), f.border.end(),
                            [&](EdgeUse use) { return isStraightOn(pattern[use.edge], moves); });
  measure(body, body.hull.size() != outer, pattern.tolerance.match());
  return body;
}

namespace {

/// Whether the paper goes on straight across the side of a part.
bool runsOn(const CreasePattern& pattern, const std::vector<bool>& moves, FacetId facet,
            std::int32_t tag) {
  if (tag == ConvexPart::kInner) return true;
  return isStraightOn(pattern[pattern[facet].border[static_cast<std::size_t>(tag)].edge], moves);
}

/// Takes in the sides that do not go on, and blunts the corners of those that do.
std::vector<Vec2> takenIn(const ConvexPart& part, const std::vector<bool>& isOpen, double margin,
                          double eps) {
  const std::size_t n = part.points.size();
  std::vector<Vec2> left = part.points;
  for (std::size_t i = 0; i < n && !left.empty(); ++i) {
    const Vec2 a = part.points[i];
    const Vec2 b = part.points[(i + 1) % n];
    if (a == b) continue;
    const Vec2 along = normalized(b - a);
    if (!isOpen[i]) {
      const Vec2 in = perpendicular(along) * margin;
      left = clipLeft(left, a + in, b + in, eps);
    }
    const std::size_t before = (i + n - 1) % n;
    if (!isOpen[i] && !isOpen[before]) continue;
    const Vec2 back = part.points[before] - a;
    if (left.empty() || length(back) == 0) continue;
    const Vec2 middle = along + normalized(back);
    if (length(middle) <= kParallel) continue;
    const Vec2 in = normalized(middle);
    const Vec2 foot = a + in * margin;
    left = clipLeft(left, foot, foot - perpendicular(in), eps);
  }
  return left;
}

struct BorderSide {
  Vec2 from;
  Vec2 to;
};

/// Takes in what is left of a part from sides of the border that belong to other parts: next to a
/// sliver the border is nearer than the sides of the part.
std::vector<Vec2> clearOf(std::vector<Vec2> left, const std::vector<BorderSide>& sides,
                          double margin, double eps) {
  for (const BorderSide& side : sides) {
    if (left.size() < 3) return {};
    const Vec2 along = normalized(side.to - side.from);
    const Vec2 in = perpendicular(along);
    const double span = distance(side.from, side.to);
    bool isNear = false;
    bool isBehind = false;
    for (const Vec2 corner : left) {
      const Vec2 p = corner - side.from;
      const double depth = dot(in, p);
      isBehind = isBehind || depth < -eps;
      isNear =
          isNear || (depth < margin && dot(along, p) > -margin && dot(along, p) < span + margin);
    }
    if (isBehind || !isNear) continue;
    const Vec2 a = side.from + in * margin;
    left = clipLeft(left, a, a + along, eps);
  }
  return left;
}

Patch patchOf(const std::vector<Vec2>& points, const Rigid& placed) {
  Patch patch;
  patch.normal = placed.z;
  patch.offset = dot(placed.z, placed.origin);
  patch.zLow = HUGE_VAL;
  patch.zHigh = -HUGE_VAL;
  for (const Vec2 p : points) {
    const Vec3 at = placed.apply(p);
    patch.points.push_back(at);
    patch.zLow = std::min(patch.zLow, at.z);
    patch.zHigh = std::max(patch.zHigh, at.z);
    patch.rHigh = std::max(patch.rHigh, length(Vec2{at.x, at.y}));
  }
  return patch;
}

}  // namespace

std::vector<Patch> insideOf(const FoldedState& state, const std::vector<bool>& moves,
                            const AxisFrame& frame, FacetId facet, double margin) {
  const CreasePattern& pattern = state.pattern;
  const Rigid& pose = state.poseOf(facet);
  const Rigid placed{frame.direction(pose.x), frame.direction(pose.y), frame.direction(pose.z),
                     frame.toFrame(pose.origin)};
  const std::vector<ConvexPart> parts = convexParts(regionOf(pattern, facet), pattern.tolerance);
  std::vector<BorderSide> border;
  for (const ConvexPart& part : parts) {
    for (std::size_t i = 0; i < part.tags.size() && parts.size() > 1; ++i) {
      const BorderSide side{part.points[i], part.points[(i + 1) % part.points.size()]};
      if (!runsOn(pattern, moves, facet, part.tags[i]) && side.from != side.to)
        border.push_back(side);
    }
  }
  const double eps = pattern.tolerance.length();
  std::vector<Patch> patches;
  for (const ConvexPart& part : parts) {
    std::vector<bool> isOpen;
    for (const std::int32_t tag : part.tags) isOpen.push_back(runsOn(pattern, moves, facet, tag));
    const std::vector<Vec2> inside =
        clearOf(takenIn(part, isOpen, margin, eps), border, margin, eps);
    if (inside.size() < 3) continue;
    patches.push_back(patchOf(inside, placed));
    patches.back().goesOn = std::find(isOpen.begin(), isOpen.end(), true) != isOpen.end();
  }
  return patches;
}

}  // namespace kiri
