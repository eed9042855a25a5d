// Regions as convex parts: flattened, bridged, cut into triangles, joined.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/check.h"
#include "core/geometry/convex.h"
#include "core/geometry/flattened_parts.h"
#include "core/geometry/region.h"
#include "core/geometry/triangulation.h"

namespace kiri {
namespace {

bool isBefore(Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Adds the points of an arc but its end. Both directions of a curve give the same points, bit for
/// bit, so that the two sides of a curved slit fall together.
void flattenInto(Ring& ring, const Arc& arc, std::int32_t tag, double chordError) {
  if (!arc.isCurved) {
    ring.push_back({arc.start, tag});
    return;
  }
  const bool isBackwards = isBefore(arc.end, arc.start) ||
                           (arc.end == arc.start && isBefore(arc.control2, arc.control1));
  const Arc forth = isBackwards ? reversed(arc) : arc;
  const std::vector<double> parameters = flatteningParameters(forth, chordError);
  const std::size_t count = parameters.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    ring.push_back({pointAt(forth, parameters[isBackwards ? count - i : i]), tag});
  }
}

/// Outer border first, then the holes; slits are left out, for they take no paper away. Empty when
/// the border has no area.
std::vector<Ring> ringsOf(const Region& region, double chordError) {
  std::int32_t tag = 0;
  std::vector<Ring> rings;
  for (const Loop& loop : region.loops) {
    Ring ring;
    for (const Arc& arc : loop) flattenInto(ring, arc, tag++, chordError);
    ring = withoutSpikes(ring);
    if (!ring.empty()) rings.push_back(std::move(ring));
    if (rings.empty()) break;
  }
  return rings;
}

double signedAreaOf(const Ring& ring) {
  double sum = 0;
  Vec2 last = ring.back().point;
  for (const Corner& corner : ring) {
    sum += cross(last - ring[0].point, corner.point - ring[0].point);
    last = corner.point;
  }
  return sum / 2;
}

double perimeterOf(const Ring& ring) {
  double sum = 0;
  Vec2 last = ring.back().point;
  for (const Corner& corner : ring) {
    sum += distance(last, corner.point);
    last = corner.point;
  }
  return sum;
}

/// By how much the area of the parts differs from `area`.
double surplusOf(const std::vector<ConvexPart>& parts, double area) {
  for (const ConvexPart& part : parts) area -= signedArea(part.points);
  return std::abs(area);
}

ConvexPart wholeOf(const Loop& loop) {
  ConvexPart part;
  part.points.reserve(loop.size());
  part.tags.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    part.points.push_back(loop[i].start);
    part.tags.push_back(static_cast<std::int32_t>(i));
  }
  return part;
}

}  // namespace

std::vector<ConvexPart> convexParts(const Region& region, const Tolerance& tolerance) {
  return convexPartsWithin(region, tolerance, tolerance.flattening());
}

std::vector<ConvexPart> convexPartsWithin(const Region& region, const Tolerance& tolerance,
                                          double chordError) {
  KIRI_CHECK(!region.loops.empty(), "a region has a border");
  if (isConvexPolygon(region, tolerance)) return {wholeOf(region.loops[0])};
  std::vector<Ring> rings = ringsOf(region, chordError);
  if (rings.empty()) return {};
  double area = 0;
  double perimeter = 0;
  for (const Ring& ring : rings) {
    area += signedAreaOf(ring);
    perimeter += perimeterOf(ring);
  }
  Ring border = std::move(rings.front());
  rings.erase(rings.begin());
  const Ring ring = bridged(std::move(border), std::move(rings));
  std::vector<ConvexPart> parts = convexPartsOf(ring, Trust::Simple);
  const double surplus = surplusOf(parts, area);
  if (surplus <= tolerance.length() * perimeter) return parts;
  // Curves that run nearer to each other than the flattening have polylines that cross.
  std::vector<ConvexPart> careful = convexPartsOf(ring, Trust::MayCross);
  return surplusOf(careful, area) < surplus ? careful : parts;
}

}  // namespace kiri
