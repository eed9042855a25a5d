// The sixth construction: a line that puts two points onto two lines, by a cubic equation.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/geometry/rigid.h"
#include "editor/snap/constructions.h"

namespace kiri {
namespace {

/// A point that shall come to lie on a line: dot(normal, p) is `away` more there than at the point.
struct Wish {
  Vec2 point;
  Vec2 normal;
  double away = 0;
};

/// A fold line with unit normal n and offset c takes p to p + 2 (c - n.p) n, which fulfils a wish
/// when 2 (c - n.p) (n.normal) = away. Two wishes leave, with c eliminated, a form of degree three
/// in n, homogeneous for n.n = 1: its zeros are the directions of the common tangents of two
/// parabolas (Beloch 1936). Lengths are in units of the drawing, counted from its middle.
class TwoWishes {
 public:
  TwoWishes(const Wish& a, const Wish& b) : wishes_{a, b} {}

  double form(Vec2 n) const {
    const auto& [a, b] = wishes_;
    const double p = dot(n, a.normal);
    const double q = dot(n, b.normal);
    return 2 * dot(n, a.point - b.point) * p * q + dot(n, n) * (a.away * q - b.away * p);
  }

  /// The offset of the line with this unit normal that fulfils the wish that tells more about it.
  double offset(Vec2 n) const {
    const Wish& w = better(n);
    return dot(n, w.point) + w.away / (2 * dot(n, w.normal));
  }

  /// By how much a wish is missed then; at least what rounding may hide in a line far away. (Onto
  /// parallels a form has a zero that means a line infinitely far.)
  double miss(Vec2 n) const {
    const double c = offset(n);
    double most = std::abs(c) * std::numeric_limits<double>::epsilon();
    for (const Wish& w : wishes_) {
      most = std::max(most, std::abs(2 * (c - dot(n, w.point)) * dot(n, w.normal) - w.away));
    }
    return most;
  }

 private:
  const Wish& better(Vec2 n) const {
    const bool isFirst = std::abs(dot(n, wishes_[0].normal)) >= std::abs(dot(n, wishes_[1].normal));
    return wishes_[isFirst ? 0 : 1];
  }

  std::array<Wish, 2> wishes_;
};

/// Coefficients of a polynomial of degree three, the constant first.
using Cubic = std::array<double, 4>;

double valueAt(const Cubic& k, double t) { return ((k[3] * t + k[2]) * t + k[1]) * t + k[0]; }

/// Where the slope of the polynomial is zero, in order: two places or none. k[3] is not zero.
std::vector<double> turnsOf(const Cubic& k) {
  const double a = 3 * k[3];
  const double b = k[2];  // half of the coefficient
  const double c = k[1];
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return {};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double first = q / a;
  const double second = q == 0 ? first : c / q;
  return {std::min(first, second), std::max(first, second)};
}

/// The zero between two places where the signs differ, to the last bit.
double zeroBetween(const Cubic& k, double low, double high) {
  const bool isNegativeLow = valueAt(k, low) < 0;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) return middle;
    ((valueAt(k, middle) < 0) == isNegativeLow ? low : high) = middle;
  }
}

/// Zeros and turns of the polynomial, in order: among them are all places where it is as good as
/// zero.
std::vector<double> candidatesOf(const Cubic& k) {
  const double bound =
      1 + std::max({std::abs(k[0]), std::abs(k[1]), std::abs(k[2])}) / std::abs(k[3]);
  const std::vector<double> turns = turnsOf(k);
  std::vector<double> ends{-bound};
  ends.insert(ends.end(), turns.begin(), turns.end());
  ends.push_back(bound);
  std::vector<double> out = turns;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if ((valueAt(k, ends[i]) < 0) == (valueAt(k, ends[i + 1]) < 0)) continue;
    out.push_back(zeroBetween(k, ends[i], ends[i + 1]));
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::optional<Wish> wishOf(Vec2 moved, const Line2& onto, Vec2 origin, double unit,
                           double resolution) {
  if (!(distance(onto.from, onto.to) > resolution)) return std::nullopt;
  const Vec2 normal = perpendicular(normalized(onto.to - onto.from));
  return Wish{(moved - origin) / unit, normal, dot(normal, onto.from - moved) / unit};
}

}  // namespace

std::vector<Line2> pointsOntoLines(Vec2 movedA, const Line2& ontoA, Vec2 movedB, const Line2& ontoB,
                                   double resolution) {
  const std::array<Vec2, 6> all{movedA, ontoA.from, ontoA.to, movedB, ontoB.from, ontoB.to};
  Vec2 origin;
  for (const Vec2 p : all) origin = origin + p / static_cast<double>(all.size());
  double unit = resolution;
  for (const Vec2 p : all) unit = std::max(unit, distance(p, origin));
  const std::optional<Wish> a = wishOf(movedA, ontoA, origin, unit, resolution);
  const std::optional<Wish> b = wishOf(movedB, ontoB, origin, unit, resolution);
  if (!a || !b) return {};
  const TwoWishes wishes(*a, *b);
  const double near = resolution / unit;

  // Turned so that no zero is far away: the y axis goes where the form is large.
  constexpr int kDirections = 12;
  Vec2 y{0, 1};
  for (int i = 0; i < kDirections; ++i) {
    const CosSin direction = cosSinDegrees(180.0 * i / kDirections);
    const Vec2 n{direction.cos, direction.sin};
    if (std::abs(wishes.form(n)) > std::abs(wishes.form(y))) y = n;
  }
  const double largest = wishes.form(y);
  if (std::abs(largest) <= near) return {};  // any number of lines, or a wish twice
  const Vec2 x = -perpendicular(y);
  const double plus = wishes.form(x + y);
  const double minus = wishes.form(x - y);
  const double none = wishes.form(x);
  const Cubic k{none, (plus - minus) / 2 - largest, (plus + minus) / 2 - none, largest};

  // Zeros between which the wishes are never missed by more than the resolution are one.
  std::vector<Line2> out;
  std::optional<double> last;
  const auto normalAt = [&](double t) { return normalized(x + y * t); };
  for (const double t : candidatesOf(k)) {
    if (!(wishes.miss(normalAt(t)) <= near)) continue;
    if (last && wishes.miss(normalAt((*last + t) / 2)) <= near) continue;
    last = t;
    const Vec2 n = normalAt(t);
    const Vec2 middle = origin + n * (wishes.offset(n) * unit);
    const Vec2 half = perpendicular(n) * unit;
    out.push_back({middle - half, middle + half});
  }
  return out;
}

}  // namespace kiri
