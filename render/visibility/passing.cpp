// The lines in which facets of different planes pass through each other.
// SPDX-License-Identifier: MIT
#include "render/visibility/passing.h"

#include <algorithm>

#include "core/geometry/convex.h"
#include "render/visibility/grid.h"

namespace kiri {
namespace {

using Polygon = std::vector<Vec2>;

std::vector<Polygon> convexPartsIn(const FacetView& view, const Tolerance& tolerance) {
  std::vector<Polygon> out;
  for (ConvexPart& part : convexParts(view.region(), tolerance))
    out.push_back(std::move(part.points));
  return out;
}

/// The part of the line where a and b are equally near that lies in `box`. It may be longer than
/// the place where both facets are: what is too long has the same facet on both hands.
void appendLine(const FacetView& a, const FacetView& b, const Box& box,
                std::vector<PassingLine>& out) {
  const Vec2 rise = a.slope - b.slope;
  const Vec2 middle = lerp(box.low, box.high, 0.5);
  const Vec2 foot = middle - rise * ((a.depthAt(middle) - b.depthAt(middle)) / dot(rise, rise));
  const Vec2 along = perpendicular(normalized(rise));
  double from = -distance(box.low, box.high);
  double to = -from;
  const auto clip = [&](double start, double direction, double low, double high) {
    if (direction == 0) return;
    const double t0 = (low - start) / direction;
    const double t1 = (high - start) / direction;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  };
  clip(foot.x, along.x, box.low.x, box.high.x);
  clip(foot.y, along.y, box.low.y, box.high.y);
  if (from < to) out.push_back({foot + along * from, foot + along * to});
}

/// True when one facet is in front at one place and the other at another, by more than where they
/// only touch.
bool passThrough(const FacetViews& views, const FacetView& a, const FacetView& b,
                 const std::vector<Polygon>& partsOfA, const std::vector<Polygon>& partsOfB) {
  const double slack = views.depthTolerance(a, b);
  double low = 0;
  double high = 0;
  for (const Polygon& p : partsOfA) {
    for (const Polygon& q : partsOfB) {
      for (const Vec2 corner : intersection(p, q, views.tolerance().match())) {
        const double ahead = a.depthAt(corner) - b.depthAt(corner);
        low = std::min(low, ahead);
        high = std::max(high, ahead);
      }
    }
  }
  return low < -slack && high > slack;
}

Box common(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

}  // namespace

std::vector<PassingLine> passingLines(const FacetViews& views,
                                      const std::vector<std::uint32_t>& inSight) {
  std::vector<PassingLine> out;
  if (inSight.empty()) return out;
  const auto& all = views.all();
  const double eps = views.tolerance().match();
  const double beyond = 16 * eps;  // lines end clear of the borders that they cross
  const bool isOnePlane = std::all_of(inSight.begin(), inSight.end(), [&](std::uint32_t f) {
    return all[f].set == all[inSight.front()].set;
  });
  if (isOnePlane) return out;

  Box box = all[inSight.front()].box;
  Vec2 sum;
  for (const std::uint32_t f : inSight) {
    box = joined(box, all[f].box);
    sum = sum + (all[f].box.high - all[f].box.low);
  }
  Grid grid(box, sum / static_cast<double>(inSight.size()), inSight.size());
  std::vector<std::uint32_t> met(all.size(), 0);
  std::vector<std::vector<Polygon>> parts(all.size());
  std::uint32_t stamp = 0;
  for (const std::uint32_t f : inSight) {
    parts[f] = convexPartsIn(all[f], views.tolerance());
    ++stamp;
    grid.visit(all[f].box, [&](std::uint32_t g) {
      if (met[g] == stamp || all[g].set == all[f].set) return;
      met[g] = stamp;
      if (!boxesMeet(all[f].box, all[g].box, eps)) return;
      if (!passThrough(views, all[f], all[g], parts[f], parts[g])) return;
      appendLine(all[f], all[g], grown(common(all[f].box, all[g].box), beyond), out);
    });
    grid.addBox(all[f].box, f);
  }
  return out;
}

}  // namespace kiri
