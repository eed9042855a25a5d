// Root finding by monotone pieces: the roots of the derivative part the roots of the polynomial.
// SPDX-License-Identifier: MIT
#include "core/geometry/bernstein.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/check.h"

namespace kiri::bernstein {
namespace {

using Coefficients = std::array<double, kMaxDegree + 1>;

/// Coefficients of the derivative, one fewer.
std::size_t derive(std::span<const double> c, Coefficients& result) {
  const std::size_t degree = c.size() - 1;
  for (std::size_t i = 0; i < degree; ++i) {
    result[i] = (c[i + 1] - c[i]) * static_cast<double>(degree);
  }
  return degree;
}

/// The sign change between `low` and `high`, where the polynomial is monotone and its values have
/// opposite signs.
double bracketed(std::span<const double> c, std::span<const double> slope, double low, double high,
                 bool isNegativeAtLow) {
  constexpr int kMostSteps = 80;
  double t = 0.5 * (low + high);
  for (int i = 0; i < kMostSteps; ++i) {
    const double value = valueAt(c, t);
    if (value == 0) return t;
    ((value < 0) == isNegativeAtLow ? low : high) = t;
    const double derivative = valueAt(slope, t);
    double next = derivative == 0 ? low : t - value / derivative;
    // Newton, but by halves when it leaves the bracket or is slow to shrink it.
    if (!(next > low && next < high) || i % 8 == 7) next = 0.5 * (low + high);
    if (next == t || next <= low || next >= high) return next;
    t = next;
  }
  return t;
}

/// 0 and 1 and, between them, where the derivative changes its sign.
std::vector<double> monotoneBounds(std::span<const double> slope) {
  std::vector<double> bounds{0};
  if (slope.size() > 1) {
    const std::vector<double> turns = signChanges(slope);
    bounds.insert(bounds.end(), turns.begin(), turns.end());
  }
  bounds.push_back(1);
  return bounds;
}

bool hasOneSign(std::span<const double> c) {
  return std::all_of(c.begin(), c.end(), [](double v) { return v >= 0; }) ||
         std::all_of(c.begin(), c.end(), [](double v) { return v <= 0; });
}

}  // namespace

double valueAt(std::span<const double> coefficients, double t) {
  Coefficients c{};
  std::copy(coefficients.begin(), coefficients.end(), c.begin());
  const double s = 1 - t;
  for (std::size_t n = coefficients.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) c[i] = s * c[i] + t * c[i + 1];
  }
  return c[0];
}

std::vector<double> signChanges(std::span<const double> coefficients) {
  KIRI_CHECK(coefficients.size() <= kMaxDegree + 1, "polynomials have degree 5 at most");
  if (hasOneSign(coefficients)) return {};
  if (coefficients.size() == 2) return {coefficients[0] / (coefficients[0] - coefficients[1])};
  Coefficients buffer{};
  const std::span<const double> slope(buffer.data(), derive(coefficients, buffer));
  const std::vector<double> bounds = monotoneBounds(slope);
  std::vector<double> result;
  double before = 0;  // last value that is not zero, and where
  double low = 0;
  for (const double high : bounds) {
    const double value = valueAt(coefficients, high);
    if (value == 0) continue;
    if (before != 0 && (before < 0) != (value < 0)) {
      result.push_back(bracketed(coefficients, slope, low, high, before < 0));
    }
    before = value;
    low = high;
  }
  return result;
}

std::vector<double> contacts(std::span<const double> coefficients, double nearZero) {
  if (std::all_of(coefficients.begin(), coefficients.end(),
                  [&](double v) { return std::abs(v) <= nearZero; })) {
    return {};
  }
  if (std::all_of(coefficients.begin(), coefficients.end(),
                  [&](double v) { return v > nearZero; }) ||
      std::all_of(coefficients.begin(), coefficients.end(),
                  [&](double v) { return v < -nearZero; })) {
    return {};
  }
  Coefficients buffer{};
  const std::span<const double> slope(buffer.data(), derive(coefficients, buffer));
  const std::vector<double> bounds = monotoneBounds(slope);
  std::vector<double> result;
  bool wasNear = false;
  double before = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const double value = valueAt(coefficients, bounds[i]);
    const bool isNear = std::abs(value) <= nearZero;
    if (isNear && wasNear) {
      // A stretch within reach of zero is one contact: an end of the arc, else the last turn.
      if (bounds[i] == 1 || result.back() != 0) result.back() = bounds[i];
    } else if (isNear) {
      result.push_back(bounds[i]);
    } else if (i > 0 && !wasNear && (before < 0) != (value < 0)) {
      result.push_back(bracketed(coefficients, slope, bounds[i - 1], bounds[i], before < 0));
    }
    wasNear = isNear;
    before = value;
  }
  return result;
}

}  // namespace kiri::bernstein
