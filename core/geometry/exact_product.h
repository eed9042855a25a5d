// A product of doubles without loss.
// SPDX-License-Identifier: MIT
#pragma once

namespace kiri {

/// A product and the rounding error that was made in computing it: high + low is exact.
struct ExactProduct {
  double high = 0;
  double low = 0;
};

/// Source: Dekker's splitting. Needs no fused multiply-add, so the bits agree everywhere.
inline ExactProduct exactProduct(double a, double b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const double ca = kSplit * a;
  const double cb = kSplit * b;
  const double ah = ca - (ca - a);
  const double bh = cb - (cb - b);
  const double al = a - ah;
  const double bl = b - bh;
  const double product = a * b;
  return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

}  // namespace kiri
