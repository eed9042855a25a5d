// Places between the knots by monotone cubic interpolation, then one B-spline through them.
// SPDX-License-Identifier: MIT
#include "core/leaf/margin.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/geometry/bspline.h"
#include "core/geometry/tolerance.h"
#include "core/leaf/folded_half.h"

namespace kiri {
namespace {

/// How far the curve goes on beyond the paper, in lengths of the mid-vein.
constexpr double kBeyond = 0.05;
/// A uniform spline wants data points that are evenly spaced: not farther apart than this part of
/// the whole, and near close knots nearer, growing by this part of the distance from them.
constexpr double kWidest = 0.04;
constexpr double kGrowth = 0.4;
/// Samples of a gap between knots by which data points are spread over it.
constexpr int kMarginSamples = 32;
constexpr int kDensest = 4;

/// By distance from the petiole, which falls all along the margin; of two rays that end in one
/// place one.
std::vector<MarginKnot> inOrder(std::vector<MarginKnot> knots) {
  std::sort(knots.begin(), knots.end(), [](const MarginKnot& a, const MarginKnot& b) {
    return a.length != b.length ? a.length > b.length : a.folded < b.folded;
  });
  const auto isSame = [](const MarginKnot& a, const MarginKnot& b) {
    return a.length - b.length <= kParallel && std::abs(b.folded - a.folded) <= kSameAngle;
  };
  knots.erase(std::unique(knots.begin(), knots.end(), isSame), knots.end());
  return knots;
}

/// Folded direction and distance as functions of the way along the chords between the knots; each
/// rises or falls between two knots as its ends do (Fritsch and Butland 1984).
class MarginThread {
 public:
  explicit MarginThread(const std::vector<MarginKnot>& knots) : ways_{0} {
    for (const MarginKnot& knot : knots) {
      values_.push_back({knot.folded, knot.length});
      places_.push_back(polarPlace(knot.folded, knot.length));
      if (places_.size() < 2) continue;
      ways_.push_back(ways_.back() + distance(places_[places_.size() - 2], places_.back()));
    }
    for (std::size_t i = 0; i < knots.size(); ++i) slopes_.push_back(slopeAt(i));
  }

  std::size_t gaps() const { return ways_.size() - 1; }
  Vec2 knot(std::size_t i) const { return places_[i]; }
  double gap(std::size_t i) const { return ways_[i + 1] - ways_[i]; }

  /// A place in gap `i`, t from 0 to 1.
  Vec2 at(std::size_t i, double t) const {
    const double u = 1 - t;
    const Vec2 value = values_[i] * (u * u * (1 + 2 * t)) + values_[i + 1] * (t * t * (1 + 2 * u)) +
                       (slopes_[i] * u - slopes_[i + 1] * t) * (gap(i) * t * u);
    return polarPlace(value.x, value.y);
  }

  /// How far apart data points should be at t of gap `i`.
  double spacing(std::size_t i, double t) const {
    const double way = ways_[i] + t * gap(i);
    double spacing = ways_.back() * kWidest;
    for (std::size_t k = 0; k < gaps(); ++k) {
      const double away = std::max({ways_[k] - way, way - ways_[k + 1], 0.0});
      spacing = std::min(spacing, gap(k) + kGrowth * away);
    }
    return spacing;
  }

 private:
  Vec2 slopeAt(std::size_t i) const {
    if (i == 0) return secant(0);
    if (i + 1 == values_.size()) return secant(i - 1);
    const double w1 = 2 * gap(i) + gap(i - 1);
    const double w2 = gap(i) + 2 * gap(i - 1);
    const auto mean = [&](double before, double after) {
      return before * after > 0 ? (w1 + w2) / (w1 / before + w2 / after) : 0;
    };
    const Vec2 before = secant(i - 1);
    const Vec2 after = secant(i);
    return {mean(before.x, after.x), mean(before.y, after.y)};
  }
  Vec2 secant(std::size_t i) const { return (values_[i + 1] - values_[i]) / gap(i); }

  std::vector<Vec2> values_;  ///< x: folded direction, degrees; y: distance
  std::vector<Vec2> places_;
  std::vector<double> ways_;
  std::vector<Vec2> slopes_;
};

/// The data points, the knots among them. `density` 2: twice as many.
std::vector<Vec2> pointsAlong(const std::vector<MarginKnot>& knots, int density) {
  const MarginThread thread(knots);
  std::vector<Vec2> points = {thread.knot(0)};
  for (std::size_t i = 0; i < thread.gaps(); ++i) {
    std::vector<double> counts = {0};  // of data points up to a sample
    for (int k = 0; k < kMarginSamples; ++k) {
      const double t = (k + 0.5) / kMarginSamples;
      counts.push_back(counts.back() + thread.gap(i) / kMarginSamples / thread.spacing(i, t));
    }
    const int parts = std::max(1, static_cast<int>(std::lround(density * counts.back())));
    std::size_t k = 0;
    for (int p = 1; p < parts; ++p) {
      const double wanted = counts.back() * p / parts;
      while (counts[k + 1] < wanted) ++k;
      const double beyond = (wanted - counts[k]) / (counts[k + 1] - counts[k]);
      points.push_back(thread.at(i, (static_cast<double>(k) + beyond) / kMarginSamples));
    }
    points.push_back(thread.knot(i + 1));
  }
  return points;
}

/// Goes straight on beyond the last point, with spacing that grows as elsewhere.
void goOn(std::vector<Vec2>& points) {
  const Vec2 end = points.back();
  const Vec2 step = end - points[points.size() - 2];
  const Vec2 way = normalized(step);
  double spacing = length(step);
  for (double beyond = 0; beyond < kBeyond; spacing *= 1 + kGrowth) {
    beyond += spacing;
    points.push_back(end + way * beyond);
  }
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

MarginCurve curveThrough(const std::vector<MarginKnot>& knots, int density) {
  std::vector<Vec2> points = pointsAlong(inOrder(knots), density);
  goOn(points);
  std::reverse(points.begin(), points.end());
  goOn(points);
  std::reverse(points.begin(), points.end());
  MarginCurve curve;
  curve.controls = interpolated(points);
  curve.arcs = openSpline(curve.controls, SplineEnds::Clamped);
  for (const MarginKnot& knot : knots) {
    const Vec2 at = polarPlace(knot.folded, knot.length);
    const auto nearer = [&](Vec2 a, Vec2 b) { return distance(a, at) < distance(b, at); };
    const auto nearest = std::min_element(points.begin(), points.end(), nearer);
    curve.crossings.push_back(static_cast<std::size_t>(nearest - points.begin()));
  }
  return curve;
}

}  // namespace

Result<MarginCurve> marginCurve(const FoldedHalf& half, const std::vector<MarginKnot>& knots) {
  // More data points keep the spline nearer to its thread, whose lengths fall.
  for (int density = 1;; density *= 2) {
    MarginCurve curve = curveThrough(knots, density);
    const Status status = checkMargin(half, knots, curve);
    if (status) return curve;
    if (density >= kDensest) return status.error();
  }
}

}  // namespace kiri
