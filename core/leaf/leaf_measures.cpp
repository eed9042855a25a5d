// What botanists measure on a leaf: size, shape, lobes and sinuses, symmetry.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/arc_range.h"
#include "core/geometry/rigid.h"
#include "core/leaf/outline_shape.h"
#include "core/leaf/radial_extremes.h"
#include "core/paper/contours.h"

namespace kiri {
namespace {

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

Range rangeOf(const Loop& contour, Vec2 direction) {
  Range all = rangeAlong(contour.front(), direction);
  for (const Arc& arc : contour) {
    const Range range = rangeAlong(arc, direction);
    all = {std::min(all.low, range.low), std::max(all.high, range.high)};
  }
  return all;
}

/// How much more one half has than the other, as part of what both have on average.
double unevenness(double left, double right) {
  return left + right > 0 ? 2 * std::abs(right - left) / (left + right) : 0;
}

/// Extents along and across the axis. `turned` is in its frame, as in what follows.
void measureExtents(LeafMeasures& m, const Loop& turned) {
  const Range across = rangeOf(turned, {1, 0});
  const Range along = rangeOf(turned, {0, 1});
  m.leftWidth = std::max(-across.low, 0.0);
  m.rightWidth = std::max(across.high, 0.0);
  m.widthAsymmetry = unevenness(m.leftWidth, m.rightWidth);
  m.width = across.high - across.low;
  m.fullLength = along.high - along.low;
  m.aspectRatio = m.length / m.width;
  m.fullAspectRatio = m.fullLength / m.width;
}

/// Along the axis a contour sweeps no area as seen from the origin, which lies on it.
void measureHalves(LeafMeasures& m, const std::vector<Loop>& turned, const Tolerance& tolerance) {
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
  m.areaAsymmetry = unevenness(m.leftArea, m.rightArea);
}

/// The angle at a point of the axis between the first places to either side where the line across
/// the axis at `height` meets the margin.
std::optional<double> openingAt(const Loop& turned, Vec2 vertex, double height,
                                const Tolerance& tolerance) {
  std::optional<double> left;
  std::optional<double> right;
  for (const Arc& arc : turned) {
    for (const double t : lineMeetings(arc, {0, height}, {1, 0}, tolerance)) {
      const double x = pointAt(arc, t).x;
      if (x < 0) left = std::max(left.value_or(x), x);
      if (x > 0) right = std::min(right.value_or(x), x);
    }
  }
  if (!left || !right) return std::nullopt;
  const Vec2 a = Vec2{*left, height} - vertex;
  const Vec2 b = Vec2{*right, height} - vertex;
  return std::abs(angleDegrees(dot(a, b), cross(a, b)));
}

void measureShape(LeafMeasures& m, const std::vector<Loop>& contours, const Tolerance& tolerance) {
  const OutlineShape shape = shapeOf(contours, tolerance);
  m.area = shape.area;
  m.perimeter = shape.perimeter;
  m.major = shape.major;
  m.minor = shape.minor;
  m.feret = shape.feret;
  m.circularity = 4 * std::numbers::pi * shape.area / (shape.perimeter * shape.perimeter);
  m.roundness = 4 * shape.area / (std::numbers::pi * shape.major * shape.major);
  m.solidity = shape.area / shape.hullArea;
  m.perimeterRatio = shape.perimeter / shape.hullPerimeter;
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

/// Where the axis ends: of a direction that was given the tip nearest to it, else the end of the
/// outline.
Vec2 apexAlong(const LeafMeasures& m, const Loop& contour) {
  const MarginPoint* best = nullptr;
  for (const MarginPoint& point : m.margin) {
    if (!point.isLobe || std::abs(point.angle) >= 90) continue;
    if (best == nullptr || std::abs(point.angle) < std::abs(best->angle)) best = &point;
  }
  if (best != nullptr) return best->place;
  return m.petiole + m.axis * (rangeOf(contour, m.axis).high - dot(m.petiole, m.axis));
}

/// Petiole, axis, margin and length; returns the apex.
Vec2 findAxis(LeafMeasures& m, const CreasePattern& pattern, const std::vector<Loop>& loops,
              const MeasureOptions& options) {
  const Loop& contour = loops.front();
  const std::optional<Vec2> petiole = options.petiole ? options.petiole : petioleOfVeins(pattern);
  m.petiole = petiole ? *petiole : shapeOf(loops, pattern.tolerance).centroid;
  const Vec2 farthest = farthestFrom(contour, m.petiole);
  m.axis = normalized(farthest - m.petiole);
  if (options.axis) {
    const CosSin w = cosSinDegrees(*options.axis);
    m.axis = {w.sin, w.cos};
  }
  m.margin = marginPoints(contour, {m.petiole, m.axis},
                          options.prominence * distance(farthest, m.petiole));
  for (const MarginPoint& point : m.margin) {
    ++(point.isLobe ? m.lobeCount : m.sinusCount);
    if (point.isLobe) m.royerToothCount += point.isTooth ? 1 : 0;
    if (point.isLobe) m.royerLobeCount += point.reach > kLobeReach ? 1 : 0;
  }
  m.oiv = oivMeasures(pattern, m.petiole, m.margin);
  const Vec2 apex = options.axis ? apexAlong(m, contour) : farthest;
  m.length = dot(apex - m.petiole, m.axis);
  return apex;
}

Status checkOptions(const MeasureOptions& options) {
  if (options.prominence >= 0 && options.prominence < 1) return std::monostate{};
  return Error{ErrorCode::BadValue,
               "the prominence of a lobe is a part of the longest radius, 0 "
               "to below 1"};
}

}  // namespace

std::optional<Vec2> petioleOfVeins(const CreasePattern& pattern) {
  std::vector<bool> onBorder(pattern.vertices.size(), false);
  std::vector<std::size_t> hinges(pattern.vertices.size(), 0);
  for (const Edge& edge : pattern.edges) {
    for (const VertexId v : {edge.from, edge.to}) {
      if (edge.kind == EdgeKind::Border) onBorder[v.index] = true;
      if (edge.kind == EdgeKind::Hinge) ++hinges[v.index];
    }
  }
  std::optional<VertexId> best;
  bool isTie = false;
  for (std::size_t i = 0; i < pattern.vertices.size(); ++i) {
    const VertexId v(i);
    if (!onBorder[i] || hinges[i] < 2) continue;
    if (best && hinges[i] == hinges[best->index]) isTie = true;
    if (best && hinges[i] <= hinges[best->index]) continue;
    best = v;
    isTie = false;
  }
  if (!best || isTie) return std::nullopt;
  return pattern[*best];
}

Result<LeafMeasures> measuresOf(const CreasePattern& pattern, const MeasureOptions& options) {
  if (Status status = checkOptions(options); !status) return status.error();
  const Result<std::vector<Loop>> loops = contourLoops(pattern);
  if (!loops) return loops.error();
  const Tolerance& tolerance = pattern.tolerance;
  LeafMeasures m;
  const Vec2 apex = findAxis(m, pattern, *loops, options);
  std::vector<Loop> turned = *loops;
  for (Loop& loop : turned) {
    for (Arc& arc : loop) arc = inAxisFrame(arc, m.petiole, m.axis);
  }
  const Loop& contour = turned.front();
  measureShape(m, *loops, tolerance);
  measureExtents(m, contour);
  measureHalves(m, turned, tolerance);
  m.asymmetry = asymmetryOf(contour, tolerance);
  const Vec2 d = apex - m.petiole;
  const Vec2 turnedApex{-cross(m.axis, d), dot(m.axis, d)};
  m.apexAngle = openingAt(contour, turnedApex, 0.75 * m.length, tolerance);
  m.baseAngle = openingAt(contour, {0, 0}, 0.25 * m.length, tolerance);
  return m;
}

}  // namespace kiri
