// Crossings and touches of two cubic arcs, found by subdivision.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/cubic.h"

namespace kiri {

/// An interval of parameters.
struct Span {
  double low = 0;
  double high = 1;
};

/// Places where the part `s` of `a` and the part `r` of `b` cross or touch within
/// `tolerance.length()`, in no particular order; a place may be listed more than once by parameters
/// that differ a little. Parameters are those of the whole arcs. Two arcs that coincide along a
/// stretch within the parts give some points of the stretch: leave such stretches out.
std::vector<Meeting> curveMeetings(const Arc& a, Span s, const Arc& b, Span r,
                                   const Tolerance& tolerance);

}  // namespace kiri
