// Least squares with few unknowns; parameters are corrected between the solutions.
// SPDX-License-Identifier: MIT
#include "editor/tools/curve_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

/// What four controls, from `first` on, weigh at one parameter, and how that changes.
struct Weights {
  std::size_t first = 0;
  std::array<double, 4> at{};
  std::array<double, 4> slope{};
};

/// A uniform cubic spline with a number of controls: clamped, or closed. Arcs count 1 each.
class Basis {
 public:
  Basis(std::size_t controls, bool isClosed) : controls_(controls), isClosed_(isClosed) {}

  std::size_t controls() const { return controls_; }
  double length() const { return static_cast<double>(isClosed_ ? controls_ : controls_ - 3); }
  std::size_t index(std::size_t i) const { return isClosed_ ? i % controls_ : i; }

  /// Knot i of the control polygon: control i reaches from knot i to knot i + 4.
  double knot(std::size_t i) const {
    const double plain = static_cast<double>(i) - 3;
    return isClosed_ ? plain : std::clamp(plain, 0.0, length());
  }

  std::size_t spanOf(double u) const {
    return static_cast<std::size_t>(std::clamp(std::floor(u), 0.0, length() - 1));
  }

  /// Cox and de Boor.
  Weights at(double u) const {
    Weights w;
    w.first = spanOf(u);
    const std::size_t k = w.first + 3;
    w.at[0] = 1;
    for (std::size_t degree = 1; degree <= 3; ++degree) {
      if (degree == 3) w.slope = slopes(w.at, k);
      std::array<double, 4> next{};
      for (std::size_t i = 0; i < degree; ++i) {
        const double low = knot(k + 1 + i - degree);
        const double high = knot(k + 1 + i);
        const double part = w.at[i] / (high - low);
        next[i] += part * (high - u);
        next[i + 1] += part * (u - low);
      }
      w.at = next;
    }
    return w;
  }

 private:
  std::array<double, 4> slopes(const std::array<double, 4>& quadratic, std::size_t k) const {
    std::array<double, 4> slope{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = 3 * quadratic[i] / (knot(k + 1 + i) - knot(k - 2 + i));
      slope[i] -= part;
      slope[i + 1] += part;
    }
    return slope;
  }

  std::size_t controls_;
  bool isClosed_;
};

Vec2 combined(const Basis& basis, const std::vector<Vec2>& controls, std::size_t first,
              const std::array<double, 4>& weights) {
  Vec2 sum;
  for (std::size_t i = 0; i < 4; ++i) sum = sum + controls[basis.index(first + i)] * weights[i];
  return sum;
}

/// A symmetric positive matrix and two right sides, solved by Cholesky's factors.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t size) : size_(size), matrix_(size * size), right_(size) {}

  double& entry(std::size_t row, std::size_t column) { return matrix_[row * size_ + column]; }
  Vec2& right(std::size_t row) { return right_[row]; }

  std::vector<Vec2> solve() {
    for (std::size_t j = 0; j < size_; ++j) {
      for (std::size_t i = j; i < size_; ++i) {
        double sum = entry(i, j);
        for (std::size_t k = 0; k < j; ++k) sum -= entry(i, k) * entry(j, k);
        entry(i, j) = i == j ? std::sqrt(sum) : sum / entry(j, j);
      }
    }
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t k = 0; k < i; ++k) right_[i] = right_[i] - right_[k] * entry(i, k);
      right_[i] = right_[i] / entry(i, i);
    }
    for (std::size_t i = size_; i-- > 0;) {
      for (std::size_t k = i + 1; k < size_; ++k) right_[i] = right_[i] - right_[k] * entry(k, i);
      right_[i] = right_[i] / entry(i, i);
    }
    return right_;
  }

 private:
  std::size_t size_;
  std::vector<double> matrix_;
  std::vector<Vec2> right_;
};

/// A weak wish for an even control polygon, so that a span without points is no riddle.
constexpr double kEvenness = 1.0 / 4096;

std::vector<Vec2> leastSquares(const Basis& basis, bool isClosed, const std::vector<Vec2>& points,
                               const std::vector<double>& at) {
  const std::size_t n = basis.controls();
  NormalEquations equations(n);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Weights w = basis.at(at[p]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t row = basis.index(w.first + i);
      equations.right(row) = equations.right(row) + points[p] * w.at[i];
      for (std::size_t j = 0; j < 4; ++j)
        equations.entry(row, basis.index(w.first + j)) += w.at[i] * w.at[j];
    }
  }
  constexpr std::array<double, 3> kBend{1, -2, 1};
  for (std::size_t i = 0; i + 2 < n + (isClosed ? 2 : 0); ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b)
        equations.entry(basis.index(i + a), basis.index(i + b)) += kEvenness * kBend[a] * kBend[b];
    }
  }
  if (!isClosed) {  // the ends are given: their rows say just that, the others know it
    for (const std::size_t end : {std::size_t{0}, n - 1}) {
      const Vec2 fixed = end == 0 ? points.front() : points.back();
      for (std::size_t i = 0; i < n; ++i) {
        equations.right(i) = equations.right(i) - fixed * equations.entry(i, end);
        equations.entry(i, end) = equations.entry(end, i) = i == end ? 1 : 0;
      }
      equations.right(end) = fixed;
    }
  }
  return equations.solve();
}

/// One step of Newton towards the nearest point of the curve, for every point.
void correct(const Basis& basis, bool isClosed, const std::vector<Vec2>& controls,
             const std::vector<Vec2>& points, std::vector<double>& at) {
  constexpr double kLongest = 0.5;
  const double length = basis.length();
  for (std::size_t p = isClosed ? 0 : 1; p + (isClosed ? 0 : 1) < points.size(); ++p) {
    const Weights w = basis.at(at[p]);
    const Vec2 away = combined(basis, controls, w.first, w.at) - points[p];
    const Vec2 along = combined(basis, controls, w.first, w.slope);
    const double speed = dot(along, along);
    if (speed <= 0) continue;
    double u = at[p] - std::clamp(dot(away, along) / speed, -kLongest, kLongest);
    if (isClosed) u -= std::floor(u / length) * length;
    at[p] = std::clamp(u, 0.0, length);
  }
}

double errorOf(const Basis& basis, const std::vector<Vec2>& controls,
               const std::vector<Vec2>& points, const std::vector<double>& at) {
  double error = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Weights w = basis.at(at[p]);
    error = std::max(error, distance(combined(basis, controls, w.first, w.at), points[p]));
  }
  return error;
}

/// The stroke without points that repeat, and with points between those far apart.
std::vector<Vec2> evened(const std::vector<Vec2>& stroke, bool isClosed) {
  constexpr double kPieces = 256;
  std::vector<Vec2> path = stroke;
  if (isClosed && !path.empty()) path.push_back(path.front());
  double total = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) total += distance(path[i], path[i + 1]);
  std::vector<Vec2> points;
  if (!(total > 0)) return points;
  points.push_back(path.front());
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double away = distance(path[i], path[i + 1]);
    const int pieces = static_cast<int>(std::ceil(away / total * kPieces));
    for (int k = 1; k <= pieces; ++k)
      points.push_back(lerp(path[i], path[i + 1], static_cast<double>(k) / pieces));
  }
  if (isClosed) points.pop_back();
  return points;
}

std::vector<double> chordLengths(const std::vector<Vec2>& points, bool isClosed, double length) {
  std::vector<double> at{0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    at.push_back(at.back() + distance(points[i], points[i + 1]));
  const double total = at.back() + (isClosed ? distance(points.back(), points.front()) : 0);
  for (double& u : at) u *= length / total;
  return at;
}

FittedCurve fitWith(std::size_t controls, bool isClosed, const std::vector<Vec2>& points,
                    double tolerance) {
  constexpr int kRounds = 6;
  const Basis basis(controls, isClosed);
  std::vector<double> at = chordLengths(points, isClosed, basis.length());
  FittedCurve best;
  for (int round = 0; round < kRounds; ++round) {
    FittedCurve here{leastSquares(basis, isClosed, points, at), 0};
    correct(basis, isClosed, here.controls, points, at);
    here.error = errorOf(basis, here.controls, points, at);
    if (best.controls.empty() || here.error < best.error) best = std::move(here);
    if (best.error <= tolerance) break;
  }
  return best;
}

}  // namespace

FittedCurve fitCurve(const std::vector<Vec2>& stroke, bool isClosed, double tolerance,
                     std::size_t mostControls) {
  const std::vector<Vec2> points = evened(stroke, isClosed);
  FittedCurve best;
  if (points.size() < 4) return best;
  for (std::size_t n = 4; n <= mostControls; n += 1 + n / 8) {
    FittedCurve here = fitWith(n, isClosed, points, tolerance);
    if (best.controls.empty() || here.error < best.error) best = std::move(here);
    if (best.error <= tolerance) break;
  }
  return best;
}

std::vector<Vec2> withControlAt(const std::vector<Vec2>& controls, bool isClosed, double at) {
  // Boehm's knot, after which knots count evenly again: the curve moves a little near it only.
  const Basis basis(controls.size(), isClosed);
  const double u = std::clamp(at, 0.0, basis.length());
  const std::size_t span = basis.spanOf(u);
  std::vector<Vec2> result;
  for (std::size_t i = 0; i <= controls.size(); ++i) {
    // Of a closed curve the new controls may run over its end: count from the span on.
    const std::size_t c = isClosed ? span + i : i;
    if (c <= span) {
      result.push_back(controls[basis.index(c)]);
    } else if (c >= span + 4) {
      result.push_back(controls[basis.index(c - 1)]);
    } else {
      const double part = (u - basis.knot(c)) / (basis.knot(c + 3) - basis.knot(c));
      result.push_back(lerp(controls[basis.index(c - 1)], controls[basis.index(c)], part));
    }
  }
  if (isClosed) {
    const std::size_t back = result.size() - std::min(span, result.size() - 1) % result.size();
    std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(back % result.size()),
                result.end());
  }
  return result;
}

}  // namespace kiri
