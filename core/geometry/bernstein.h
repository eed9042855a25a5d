// Roots of polynomials in Bernstein form on the unit interval.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace kiri::bernstein {

/// Largest degree that rootsOf and valueAt take.
inline constexpr int kMaxDegree = 5;

/// Value at t of the polynomial with these Bernstein coefficients (de Casteljau; exact at 0 and 1).
double valueAt(std::span<const double> coefficients, double t);

/// Places in the open interval (0, 1) where the polynomial changes its sign, sorted. A polynomial
/// that is zero everywhere has none.
std::vector<double> signChanges(std::span<const double> coefficients);

/// Contacts of a polynomial with zero on [0, 1], sorted, each once: sign changes, and places where
/// it comes within `nearZero` of zero and turns back. Ends within `nearZero` of zero are contacts
/// at exactly 0 or 1. A polynomial within `nearZero` everywhere has none.
std::vector<double> contacts(std::span<const double> coefficients, double nearZero);

}  // namespace kiri::bernstein
