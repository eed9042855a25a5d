// The lines in which facets of different planes pass through each other.
// SPDX-License-Identifier: MIT
#include "render/visibility/passing.h"

#include <algorithm>

#include "core/geometry/convex.h"
#include "render/visibility/grid.h"

namespace kiri {
namespace {

using Polygon = std::vector<Vec2>;

std::vector<Polygon> partsOf(const FacetView& view, const Tolerance& tolerance) {
  std::vector<Polygon> out;
  for (ConvexPart& part : convexParts(view.region(), tolerance))
    out.push_back(std::move(part.points));
  return out;
}

/// The stretch of `place` along which a and b are equally near, when they pass there.
void addLine(const FacetView& a, const FacetView& b, const Polygon& place, double slack,
             std::vector<PassingLine>& out) {
  std::vector<double> ahead;
  for (const Vec2 p : place) ahead.push_back(a.depthAt(p) - b.depthAt(p));
  const auto [low, high] = std::minmax_element(ahead.begin(), ahead.end());
  if (*low >= -slack || *high <= slack) return;
  Polygon ends;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::size_t j = (i + 1) % place.size();
    if ((ahead[i] < 0) == (ahead[j] < 0)) continue;
    ends.push_back(lerp(place[i], place[j], ahead[i] / (ahead[i] - ahead[j])));
  }
  if (ends.size() == 2) out.push_back({ends[0], ends[1]});
}

}  // namespace

std::vector<PassingLine> passingLines(const FacetViews& views,
                                      const std::vector<std::uint32_t>& inSight) {
  std::vector<PassingLine> out;
  if (inSight.empty()) return out;
  const auto& all = views.all();
  const double eps = views.tolerance().match();
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
    parts[f] = partsOf(all[f], views.tolerance());
    ++stamp;
    grid.visit(all[f].box, [&](std::uint32_t g) {
      if (met[g] == stamp || all[g].set == all[f].set) return;
      met[g] = stamp;
      if (!boxesMeet(all[f].box, all[g].box, eps)) return;
      const double slack = views.depthTolerance(all[f], all[g]);
      for (const Polygon& p : parts[f]) {
        for (const Polygon& q : parts[g]) {
          const Polygon place = intersection(p, q, eps);
          if (!place.empty()) addLine(all[f], all[g], place, slack, out);
        }
      }
    });
    grid.addBox(all[f].box, f);
  }
  return out;
}

}  // namespace kiri
