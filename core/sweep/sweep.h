// Whether paper meets paper while some facets turn about an axis.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/layers/relayer.h"
#include "core/paper/folded_state.h"

namespace kiri {

enum class SweepVerdict {
  Free,      ///< nothing touches strictly between the start and the end of the motion
  Collides,  ///< a moving facet passes through a resting one
  Undecided  ///< so near a touch that rounding decides: not free, and no collision proved
};

/// What a motion meets. The members beside `verdict` tell of the first meeting; they are set unless
/// the verdict is Free.
struct SweepReport {
  SweepVerdict verdict = SweepVerdict::Free;
  FacetId moving;
  FacetId resting;
  double degrees = 0;  ///< turned since the start of the motion, same sign as Motion::degrees
  Vec3 place;          ///< model frame, mm
};

/// What the facets for which `moves` is true meet while they make the motion, the ends left out:
/// there layer order decides (see relayer). Layers that lie on each other at an end, flaps that
/// share a hinge on the axis, and paper that slides along other paper in its own plane of motion
/// are no false alarms. Exact in the angle: rotating points are a cos + b sin + c in every
/// condition. Curved borders are polylines within tolerance.flattening(). Requires: `moves` as
/// movingFacets gives it. Source: guide to algorithms 2.4.
SweepReport sweep(const FoldedState& state, const std::vector<bool>& moves, const Motion& motion);

}  // namespace kiri
