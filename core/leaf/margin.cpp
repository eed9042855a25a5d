// Lengths between the rays by monotone cubic interpolation, then one B-spline through them.
// SPDX-License-Identifier: MIT
#include "core/leaf/margin.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/geometry/bspline.h"
#include "core/geometry/rigid.h"
#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

/// How far the curve goes on beyond the paper, in lengths of the mid-vein.
constexpr double kBeyond = 0.05;
/// No more data points than this between the ends: a uniform spline wants even spacing.
constexpr double kMostGaps = 40;

Vec2 placeOf(const MarginKnot& p) {
  const CosSin w = cosSinDegrees(p.folded);
  return Vec2{w.sin, w.cos} * p.length;
}

/// By folded direction; of two rays in one direction one.
std::vector<MarginKnot> inOrder(std::vector<MarginKnot> knots) {
  std::sort(knots.begin(), knots.end(),
            [](const MarginKnot& a, const MarginKnot& b) { return a.folded < b.folded; });
  const auto isSame = [](const MarginKnot& a, const MarginKnot& b) {
    return b.folded - a.folded <= kSameAngle;
  };
  knots.erase(std::unique(knots.begin(), knots.end(), isSame), knots.end());
  return knots;
}

/// Slopes of the lengths at the knots that keep them falling (Fritsch and Butland 1984).
std::vector<double> slopesOf(const std::vector<MarginKnot>& knots) {
  const std::size_t n = knots.size();
  std::vector<double> secants;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    secants.push_back((knots[i + 1].length - knots[i].length) /
                      (knots[i + 1].folded - knots[i].folded));
  }
  std::vector<double> slopes(n, secants.front());
  slopes.back() = secants.back();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = knots[i].folded - knots[i - 1].folded;
    const double after = knots[i + 1].folded - knots[i].folded;
    const double w1 = 2 * after + before;
    const double w2 = after + 2 * before;
    slopes[i] = (w1 + w2) / (w1 / secants[i - 1] + w2 / secants[i]);
  }
  return slopes;
}

double lengthBetween(const MarginKnot& a, const MarginKnot& b, double slopeA, double slopeB,
                     double t) {
  const double h = b.folded - a.folded;
  const double u = 1 - t;
  return a.length * u * u * (1 + 2 * t) + b.length * t * t * (1 + 2 * u) +
         h * t * u * (slopeA * u - slopeB * t);
}

/// The data points, those of the rays among them, as evenly spaced as these allow.
std::vector<Vec2> pointsAlong(const std::vector<MarginKnot>& knots) {
  const std::vector<double> slopes = slopesOf(knots);
  double total = 0;
  double shortest = distance(placeOf(knots.front()), placeOf(knots.back()));
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double gap = distance(placeOf(knots[i]), placeOf(knots[i + 1]));
    total += gap;
    shortest = std::min(shortest, gap);
  }
  const double step = std::max(shortest, total / kMostGaps);
  std::vector<Vec2> points = {placeOf(knots.front())};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double gap = distance(placeOf(knots[i]), placeOf(knots[i + 1]));
    const int parts = std::max(1, static_cast<int>(std::lround(gap / step)));
    for (int k = 1; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      points.push_back(
          placeOf({"", knots[i].folded + t * (knots[i + 1].folded - knots[i].folded),
                   lengthBetween(knots[i], knots[i + 1], slopes[i], slopes[i + 1], t)}));
    }
    points.push_back(placeOf(knots[i + 1]));
  }
  return points;
}

/// The controls of the clamped spline whose pieces meet at the points, straight at its ends.
std::vector<Vec2> interpolated(const std::vector<Vec2>& points) {
  const auto n = static_cast<Eigen::Index>(points.size() + 2);
  Eigen::MatrixXd matrix(n, n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 2);
  for (Eigen::Index column = 0; column < n; ++column) {
    std::vector<Vec2> unit(points.size() + 2, Vec2{0, 0});
    unit[static_cast<std::size_t>(column)].x = 1;
    const std::vector<Arc> arcs = openSpline(unit, SplineEnds::Clamped);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      matrix(static_cast<Eigen::Index>(i), column) = arcs[i].start.x;
    }
    const Arc& first = arcs.front();
    const Arc& last = arcs.back();
    matrix(n - 3, column) = last.end.x;
    matrix(n - 2, column) = first.start.x - 2 * first.control1.x + first.control2.x;
    matrix(n - 1, column) = last.control1.x - 2 * last.control2.x + last.end.x;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    right(static_cast<Eigen::Index>(i), 0) = points[i].x;
    right(static_cast<Eigen::Index>(i), 1) = points[i].y;
  }
  const Eigen::MatrixXd solved = matrix.partialPivLu().solve(right);
  std::vector<Vec2> controls;
  for (Eigen::Index i = 0; i < n; ++i) controls.push_back({solved(i, 0), solved(i, 1)});
  return controls;
}

}  // namespace

std::vector<Vec2> marginControls(const std::vector<MarginKnot>& knots) {
  std::vector<Vec2> points = pointsAlong(inOrder(knots));
  const Vec2 ahead = normalized(points[0] - points[1]);
  const Vec2 behind = normalized(points.back() - points[points.size() - 2]);
  points.insert(points.begin(), points.front() + ahead * kBeyond);
  points.push_back(points.back() + behind * kBeyond);
  return interpolated(points);
}

}  // namespace kiri
