// Samples the contour, refines its turning points, drops the faint ones.
// SPDX-License-Identifier: MIT
#include "core/leaf/radial_extremes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

constexpr int kSamples = 16;

struct Sample {
  std::size_t arc = 0;
  double t = 0;
  double radius = 0;
};

/// Parameters at which an arc is looked at; that of the foot of the perpendicular is one of them.
std::vector<double> parametersOf(const Arc& arc, Vec2 centre) {
  std::vector<double> out;
  if (arc.isCurved) {
    for (int i = 0; i < kSamples; ++i) out.push_back(static_cast<double>(i) / kSamples);
  } else {
    out.push_back(0);
    const double foot = nearestOn(arc, centre).t;
    if (foot > 0 && foot < 1) out.push_back(foot);
  }
  return out;
}

std::vector<Sample> samplesOf(const Loop& contour, Vec2 centre) {
  std::vector<Sample> samples;
  for (std::size_t a = 0; a < contour.size(); ++a) {
    for (const double t : parametersOf(contour[a], centre)) {
      samples.push_back({a, t, distance(pointAt(contour[a], t), centre)});
    }
  }
  return samples;
}

/// The extreme of the radius on an arc between two parameters (golden section).
RadialExtreme extremeBetween(const Arc& arc, Vec2 centre, double low, double high,
                             bool isFarthest) {
  const double sign = isFarthest ? 1 : -1;
  const auto value = [&](double t) { return sign * distance(pointAt(arc, t), centre); };
  const double shrink = 1 / std::numbers::phi;
  double a = high - shrink * (high - low);
  double b = low + shrink * (high - low);
  double valueA = value(a);
  double valueB = value(b);
  while (high - low > kParallel) {
    if (valueA > valueB) {
      high = b;
      b = a;
      valueB = valueA;
      a = high - shrink * (high - low);
      valueA = value(a);
    } else {
      low = a;
      a = b;
      valueA = valueB;
      b = low + shrink * (high - low);
      valueB = value(b);
    }
  }
  const Vec2 place = pointAt(arc, (low + high) / 2);
  return {isFarthest, place, distance(place, centre)};
}

/// The turning point near a sample, on the arcs on either side of it.
RadialExtreme refined(const Loop& contour, Vec2 centre, const std::vector<Sample>& samples,
                      std::size_t i, bool isFarthest) {
  const std::size_t n = samples.size();
  const Sample& here = samples[i];
  const Sample& before = samples[(i + n - 1) % n];
  const Sample& after = samples[(i + 1) % n];
  RadialExtreme best{isFarthest, pointAt(contour[here.arc], here.t), here.radius};
  const auto consider = [&](std::size_t arc, double low, double high) {
    if (!contour[arc].isCurved || !(high > low)) return;
    const RadialExtreme found = extremeBetween(contour[arc], centre, low, high, isFarthest);
    if (isFarthest ? found.radius > best.radius : found.radius < best.radius) best = found;
  };
  consider(before.arc, before.t, before.arc == here.arc ? here.t : 1);
  consider(here.arc, here.t, after.arc == here.arc ? after.t : 1);
  return best;
}

/// All turning points, farthest and nearest by turns.
std::vector<RadialExtreme> turningPoints(const Loop& contour, Vec2 centre) {
  std::vector<Sample> samples = samplesOf(contour, centre);
  const auto isSame = [](const Sample& a, const Sample& b) { return a.radius == b.radius; };
  samples.erase(std::unique(samples.begin(), samples.end(), isSame), samples.end());
  const std::size_t n = samples.size();
  std::vector<RadialExtreme> found;
  if (n < 3) return found;
  for (std::size_t i = 0; i < n; ++i) {
    const double before = samples[(i + n - 1) % n].radius;
    const double here = samples[i].radius;
    const double after = samples[(i + 1) % n].radius;
    const bool isFarthest = here > before && here > after;
    const bool isNearest = here < before && here < after;
    if (isFarthest || isNearest) found.push_back(refined(contour, centre, samples, i, isFarthest));
  }
  return found;
}

/// Neighbours that are both farthest or both nearest become the better of the two.
void mergeAlike(std::vector<RadialExtreme>& points) {
  for (std::size_t i = 0; points.size() > 1 && i < points.size();) {
    const std::size_t next = (i + 1) % points.size();
    if (points[i].isFarthest != points[next].isFarthest) {
      ++i;
      continue;
    }
    const bool isNextBetter = points[i].isFarthest ? points[next].radius > points[i].radius
                                                   : points[next].radius < points[i].radius;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(isNextBetter ? i : next));
  }
}

}  // namespace

std::vector<RadialExtreme> radialExtremes(const Loop& contour, Vec2 centre, double prominence) {
  std::vector<RadialExtreme> points = turningPoints(contour, centre);
  mergeAlike(points);
  while (points.size() > 1) {
    const std::size_t n = points.size();
    const auto gap = [&](std::size_t i) {
      return std::abs(points[i].radius - points[(i + 1) % n].radius);
    };
    std::size_t faintest = 0;
    for (std::size_t i = 1; i < n; ++i) {
      if (gap(i) < gap(faintest)) faintest = i;
    }
    if (gap(faintest) >= prominence) break;
    const std::size_t next = (faintest + 1) % n;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(std::max(faintest, next)));
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(std::min(faintest, next)));
  }
  return points;
}

}  // namespace kiri
