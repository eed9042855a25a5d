// Regions as convex parts: flattened, bridged, cut into triangles, joined.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <utility>

#include "core/base/check.h"
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

}  // namespace

std::vector<ConvexPart> convexParts(const Region& region, const Tolerance& tolerance) {
  KIRI_CHECK(!region.loops.empty(), "a region has a border");
  if (isConvexPolygon(region, tolerance)) {
    const Loop& loop = region.loops[0];
    ConvexPart part;
    part.points.reserve(loop.size());
    part.tags.reserve(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      part.points.push_back(loop[i].start);
      part.tags.push_back(static_cast<std::int32_t>(i));
    }
    return {std::move(part)};
  }
  std::int32_t tag = 0;
  std::vector<Ring> rings;
  for (const Loop& loop : region.loops) {
    Ring ring;
    for (const Arc& arc : loop) flattenInto(ring, arc, tag++, tolerance.flattening());
    ring = withoutSpikes(ring);
    // A hole that is only a slit takes no paper away; a border without area has none to give.
    if (!ring.empty()) rings.push_back(std::move(ring));
    if (rings.empty()) return {};
  }
  Ring border = std::move(rings.front());
  rings.erase(rings.begin());
  return convexPartsOf(bridged(std::move(border), std::move(rings)));
}

}  // namespace kiri
