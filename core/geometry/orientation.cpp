// The exact orientation predicate: a quick filter, then a sum of exact products.
// SPDX-License-Identifier: MIT
#include "core/geometry/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/geometry/exact_product.h"

namespace kiri {
namespace {

int signOf(double v) { return v > 0 ? 1 : (v < 0 ? -1 : 0); }

/// A sum of doubles that loses nothing: components do not overlap and grow in size.
class ExactSum {
 public:
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const double sum = value + parts_[i];
      const double rounded = sum - value;
      const double error = (value - (sum - rounded)) + (parts_[i] - rounded);
      if (error != 0) parts_[kept++] = error;
      value = sum;
    }
    if (value != 0) parts_[kept++] = value;
    count_ = kept;
  }

  void addProduct(double a, double b) {
    const ExactProduct product = exactProduct(a, b);
    add(product.low);
    add(product.high);
  }

  int sign() const { return count_ == 0 ? 0 : signOf(parts_[count_ - 1]); }

 private:
  std::array<double, 16> parts_{};
  std::size_t count_ = 0;
};

int exactOrientation(Vec2 a, Vec2 b, Vec2 c) {
  ExactSum sum;
  sum.addProduct(a.x, b.y);
  sum.addProduct(-a.x, c.y);
  sum.addProduct(c.x, a.y);
  sum.addProduct(-a.y, b.x);
  sum.addProduct(b.x, c.y);
  sum.addProduct(-b.y, c.x);
  return sum.sign();
}

}  // namespace

int orientation(Vec2 a, Vec2 b, Vec2 c) {
  constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kBound = (3 + 16 * kHalfUlp) * kHalfUlp;
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  if (std::abs(det) > kBound * (std::abs(left) + std::abs(right))) return signOf(det);
  if (left == 0 && right == 0 && (a == c || b == c)) return 0;
  return exactOrientation(a, b, c);
}

}  // namespace kiri
