// Extremes of the radius, and how deep the sinuses between them go.
// SPDX-License-Identifier: MIT
#include "core/leaf/margin_points.h"

#include <algorithm>
#include <optional>

#include "core/geometry/rigid.h"
#include "core/geometry/tolerance.h"
#include "core/leaf/radial_extremes.h"

namespace kiri {
namespace {

/// Radii shorter than this part of the longest are the petiole itself, no sinus.
constexpr double kAtPetiole = 0.02;

using Points = std::vector<MarginPoint>;

/// The deepest sinus between a tip and the next in a direction that is at least as long, and
/// whether there is such a one.
struct Side {
  std::optional<std::size_t> sinus;
  bool endsInLonger = false;
};

Side sideOf(const Points& points, std::size_t tip, int step) {
  Side side;
  const double within = Tolerance(points[tip].length).match();
  for (auto i = static_cast<std::ptrdiff_t>(tip) + step;
       i >= 0 && i < static_cast<std::ptrdiff_t>(points.size()); i += step) {
    const auto at = static_cast<std::size_t>(i);
    if (points[at].isLobe && points[at].length >= points[tip].length - within) {
      side.endsInLonger = true;
      break;
    }
    if (points[at].isLobe) continue;
    if (!side.sinus || points[at].length < points[*side.sinus].length) side.sinus = at;
  }
  return side;
}

/// The shallower of two sinuses, where there are two.
std::optional<std::size_t> shallower(const Points& points, std::optional<std::size_t> a,
                                     std::optional<std::size_t> b) {
  if (!a || !b) return a ? a : b;
  return points[*a].length > points[*b].length ? a : b;
}

/// The sinus that parts a tip from those that are as long or longer.
std::optional<std::size_t> sinusOf(const Points& points, std::size_t tip) {
  std::optional<std::size_t> found;
  for (const int step : {-1, 1}) {
    const Side side = sideOf(points, tip, step);
    if (side.endsInLonger) found = shallower(points, found, side.sinus);
  }
  return found;
}

/// The deepest sinus between the longest tip and the first lobe beside it.
std::optional<std::size_t> sinusBeforeLobe(const Points& points, std::size_t tip, int step) {
  std::optional<std::size_t> sinus;
  for (auto i = static_cast<std::ptrdiff_t>(tip) + step;
       i >= 0 && i < static_cast<std::ptrdiff_t>(points.size()); i += step) {
    const auto at = static_cast<std::size_t>(i);
    if (points[at].isLobe && !points[at].isTooth) return sinus;
    if (points[at].isLobe) continue;
    if (!sinus || points[at].length < points[*sinus].length) sinus = at;
  }
  return std::nullopt;
}

void findReach(Points& points, Vec2 petiole) {
  if (points.empty()) return;
  const auto longest =
      static_cast<std::size_t>(std::max_element(points.begin(), points.end(),
                                                [](const MarginPoint& a, const MarginPoint& b) {
                                                  return a.length < b.length;
                                                }) -
                               points.begin());
  const auto setReach = [&](std::size_t i, std::optional<std::size_t> sinus) {
    if (!sinus) return;
    const Vec2 axis = petiole - points[i].place;
    points[i].reach = dot(points[*sinus].place - points[i].place, axis) / dot(axis, axis);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].isLobe || i == longest) continue;
    setReach(i, sinusOf(points, i));
    points[i].isTooth = points[i].reach <= kLobeReach;
  }
  setReach(longest, shallower(points, sinusBeforeLobe(points, longest, -1),
                              sinusBeforeLobe(points, longest, 1)));
}

}  // namespace

std::vector<MarginPoint> marginPoints(const Loop& contour, const LeafAxis& axis,
                                      double prominence) {
  double longest = 0;
  for (const Arc& arc : contour) longest = std::max(longest, distance(arc.start, axis.petiole));
  Points points;
  for (const RadialExtreme& e : radialExtremes(contour, axis.petiole, prominence)) {
    if (!e.isFarthest && e.radius < kAtPetiole * longest) continue;
    const Vec2 d = e.place - axis.petiole;
    points.push_back({e.isFarthest, e.place,
                      angleDegrees(dot(axis.direction, d), -cross(axis.direction, d)), e.radius, 0,
                      false});
  }
  std::sort(points.begin(), points.end(),
            [](const MarginPoint& a, const MarginPoint& b) { return a.angle < b.angle; });
  findReach(points, axis.petiole);
  return points;
}

}  // namespace kiri
