// What botanists measure on a leaf: size, shape, lobes and sinuses, symmetry.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/arc_range.h"
#include "core/geometry/convex.h"
#include "core/geometry/hull.h"
#include "core/geometry/rigid.h"
#include "core/leaf/radial_extremes.h"
#include "core/paper/contours.h"

namespace kiri {
namespace {

/// Radii shorter than this part of the longest are the petiole itself, no sinus.
constexpr double kAtPetiole = 0.02;

Loop loopOf(const CreasePattern& pattern, const std::vector<EdgeUse>& contour) {
  Loop loop;
  for (const EdgeUse use : contour) loop.push_back(arcOf(pattern, use));
  return loop;
}

Result<std::vector<Loop>> contourLoops(const CreasePattern& pattern) {
  std::vector<Loop> loops;
  std::size_t outer = 0;
  for (const auto& contour : contoursOf(pattern)) {
    loops.push_back(loopOf(pattern, contour));
    if (signedAreaOf(loops.back()) <= 0) continue;
    ++outer;
    std::swap(loops.back(), loops.front());
  }
  if (outer == 1) return loops;
  return Error{ErrorCode::BadValue, "the paper is in " + std::to_string(outer) +
                                        " pieces, and one outline is measured; keep one of them "
                                        "when cutting"};
}

/// The end of most hinges on the contour, of equals the lowest; none where no two meet.
std::optional<Vec2> hingeCentre(const CreasePattern& pattern) {
  std::vector<bool> onBorder(pattern.vertices.size(), false);
  std::vector<std::size_t> hinges(pattern.vertices.size(), 0);
  for (const Edge& edge : pattern.edges) {
    for (const VertexId v : {edge.from, edge.to}) {
      if (edge.kind == EdgeKind::Border) onBorder[v.index] = true;
      if (edge.kind == EdgeKind::Hinge) ++hinges[v.index];
    }
  }
  std::optional<VertexId> best;
  for (std::size_t i = 0; i < pattern.vertices.size(); ++i) {
    const VertexId v(i);
    if (!onBorder[i] || hinges[i] < 2) continue;
    const bool isBetter = !best || hinges[i] > hinges[best->index] ||
                          (hinges[i] == hinges[best->index] && pattern[v].y < pattern[*best].y);
    if (isBetter) best = v;
  }
  if (!best) return std::nullopt;
  return pattern[*best];
}

/// The middle of the area of the flattened loops.
Vec2 centroidOf(const std::vector<Loop>& loops, const Tolerance& tolerance) {
  double area = 0;
  Vec2 sum;
  for (const Loop& loop : loops) {
    for (const Arc& arc : loop) {
      const auto parameters = flatteningParameters(arc, tolerance.flattening());
      for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
        const Vec2 a = pointAt(arc, parameters[i]);
        const Vec2 b = pointAt(arc, parameters[i + 1]);
        area += cross(a, b);
        sum = sum + (a + b) * cross(a, b);
      }
    }
  }
  return sum / (3 * area);
}

std::vector<Vec2> flattened(const Loop& loop, const Tolerance& tolerance) {
  std::vector<Vec2> points;
  for (const Arc& arc : loop) {
    for (const double t : flatteningParameters(arc, tolerance.flattening())) {
      if (t < 1) points.push_back(pointAt(arc, t));
    }
  }
  return points;
}

Vec2 farthestFrom(const Loop& contour, Vec2 centre) {
  Vec2 best = contour.front().start;
  for (const RadialExtreme& point : radialExtremes(contour, centre, 0)) {
    if (point.isFarthest && distance(point.place, centre) > distance(best, centre)) {
      best = point.place;
    }
  }
  return best;
}

/// The arc in a frame with the petiole at the origin and the axis along +y.
Arc inAxisFrame(const Arc& arc, Vec2 petiole, Vec2 axis) {
  const auto turned = [&](Vec2 p) {
    const Vec2 d = p - petiole;
    return Vec2{-cross(axis, d), dot(axis, d)};
  };
  Arc out = arc;
  out.start = turned(arc.start);
  out.end = turned(arc.end);
  out.control1 = turned(arc.control1);
  out.control2 = turned(arc.control2);
  return out;
}

/// Measures that need the outline in the axis's frame only.
void measureAcross(LeafMeasures& m, const std::vector<Loop>& turned, const Tolerance& tolerance) {
  Range across = rangeAlong(turned.front().front(), {1, 0});
  Range along = rangeAlong(turned.front().front(), {0, 1});
  for (const Arc& arc : turned.front()) {
    const Range x = rangeAlong(arc, {1, 0});
    const Range y = rangeAlong(arc, {0, 1});
    across = {std::min(across.low, x.low), std::max(across.high, x.high)};
    along = {std::min(along.low, y.low), std::max(along.high, y.high)};
  }
  m.width = across.high - across.low;
  m.fullLength = along.high - along.low;
  m.aspectRatio = m.length / m.width;
  // Along the axis a contour sweeps no area as seen from the origin, which lies on it.
  for (const Loop& loop : turned) {
    for (const Arc& arc : loop) {
      std::vector<double> cuts = lineMeetings(arc, {0, 0}, {0, 1}, tolerance);
      cuts.insert(cuts.begin(), 0);
      cuts.push_back(1);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (!(cuts[i + 1] > cuts[i])) continue;
        const bool isLeft = pointAt(arc, (cuts[i] + cuts[i + 1]) / 2).x < 0;
        (isLeft ? m.leftArea : m.rightArea) += doubleArea(part(arc, cuts[i], cuts[i + 1])) / 2;
      }
    }
  }
}

/// Perimeter and what is compared with the circle and the convex hull. Needs the area.
void measureShape(LeafMeasures& m, const Loop& contour, const Tolerance& tolerance) {
  for (const Arc& arc : contour) m.perimeter += lengthOf(arc, tolerance.match());
  const std::vector<Vec2> hull = convexHull(flattened(contour, tolerance));
  double hullPerimeter = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    hullPerimeter += distance(hull[i], hull[(i + 1) % hull.size()]);
  }
  m.solidity = m.area / signedArea(hull);
  m.perimeterRatio = m.perimeter / hullPerimeter;
  m.circularity = 4 * std::numbers::pi * m.area / (m.perimeter * m.perimeter);
}

double distanceTo(const Loop& contour, Vec2 p) {
  double best = distance(contour.front().start, p);
  for (const Arc& arc : contour) {
    const Box box = boundsOf(arc);
    if (!areNear(box, {p, p}, best)) continue;
    best = std::min(best, nearestOn(arc, p).distance);
  }
  return best;
}

double asymmetryOf(const Loop& turned, const Tolerance& tolerance) {
  double worst = 0;
  for (const Vec2 p : flattened(turned, tolerance)) {
    worst = std::max(worst, distanceTo(turned, {-p.x, p.y}));
  }
  return worst;
}

void measureMargin(LeafMeasures& m, const Loop& turned, double prominence) {
  double longest = 0;
  for (const Arc& arc : turned) longest = std::max(longest, length(arc.start));
  for (const RadialExtreme& e : radialExtremes(turned, {0, 0}, prominence * longest)) {
    if (!e.isFarthest && e.radius < kAtPetiole * longest) continue;
    const Vec2 back = m.petiole + m.axis * e.place.y - perpendicular(m.axis) * e.place.x;
    m.margin.push_back({e.isFarthest, back, angleDegrees(e.place.y, e.place.x), e.radius});
    ++(e.isFarthest ? m.lobeCount : m.sinusCount);
  }
  std::sort(m.margin.begin(), m.margin.end(),
            [](const MarginPoint& a, const MarginPoint& b) { return a.angle < b.angle; });
}

/// Petiole, axis and length.
void findAxis(LeafMeasures& m, const CreasePattern& pattern, const std::vector<Loop>& loops,
              const MeasureOptions& options) {
  std::optional<Vec2> petiole = options.petiole ? options.petiole : hingeCentre(pattern);
  m.petiole = petiole ? *petiole : centroidOf(loops, pattern.tolerance);
  const Vec2 apex = farthestFrom(loops.front(), m.petiole);
  m.axis = normalized(apex - m.petiole);
  if (options.axis) {
    const CosSin w = cosSinDegrees(*options.axis);
    m.axis = {w.sin, w.cos};
  }
  m.length = dot(apex - m.petiole, m.axis);
}

Status checkOptions(const MeasureOptions& options) {
  if (options.prominence >= 0 && options.prominence < 1) return std::monostate{};
  return Error{ErrorCode::BadValue,
               "the prominence of a lobe is a part of the longest radius, 0 "
               "to below 1"};
}

}  // namespace

Result<LeafMeasures> measuresOf(const CreasePattern& pattern, const MeasureOptions& options) {
  if (Status status = checkOptions(options); !status) return status.error();
  const Result<std::vector<Loop>> loops = contourLoops(pattern);
  if (!loops) return loops.error();
  const Tolerance& tolerance = pattern.tolerance;
  const Loop& contour = loops->front();
  LeafMeasures m;
  findAxis(m, pattern, *loops, options);
  std::vector<Loop> turned = *loops;
  for (Loop& loop : turned) {
    for (Arc& arc : loop) arc = inAxisFrame(arc, m.petiole, m.axis);
  }
  m.area = areaOf(pattern);
  measureShape(m, contour, tolerance);
  measureAcross(m, turned, tolerance);
  m.asymmetry = asymmetryOf(turned.front(), tolerance);
  measureMargin(m, turned.front(), options.prominence);
  return m;
}

}  // namespace kiri
