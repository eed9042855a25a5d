// SPDX-License-Identifier: MIT
#include "core/cut/edge_stretch.h"

#include <algorithm>

#include "core/paper/pattern_edit.h"

namespace kiri {

std::optional<Stretch> stretchAlong(EdgeId id, const EdgeEnds& ends, Vec3 p, Vec3 q,
                                    const Tolerance& tolerance) {
  const double span = distance(p, q);
  const Vec3 along = (q - p) / span;
  const auto away = [&](Vec3 r) { return length(cross(along, r - p)); };
  if (away(ends.from) > tolerance.match() || away(ends.to) > tolerance.match()) return std::nullopt;
  const double s = dot(ends.from - p, along);
  const double t = dot(ends.to - p, along);
  const double low = std::max(0.0, std::min(s, t));
  const double high = std::min(span, std::max(s, t));
  if (high - low <= tolerance.match()) return std::nullopt;
  const auto parameter = [&](double at) { return std::clamp((at - s) / (t - s), 0.0, 1.0); };
  const double u = parameter(low);
  const double v = parameter(high);
  return Stretch{id, std::min(u, v), std::max(u, v), low, high};
}

EdgeId isolate(CreasePattern& pattern, const Stretch& stretch) {
  const double span =
      distance(pattern[pattern[stretch.edge].from], pattern[pattern[stretch.edge].to]);
  const double tol = pattern.tolerance.match();
  EdgeId id = stretch.edge;
  if ((1 - stretch.t1) * span > tol) splitEdge(pattern, id, stretch.t1);
  if (stretch.t0 * span > tol) {
    const double end = (1 - stretch.t1) * span > tol ? stretch.t1 : 1;
    splitEdge(pattern, id, stretch.t0 / end);
    id = EdgeId(pattern.edges.size() - 1);
  }
  return id;
}

}  // namespace kiri
