// Whether paper meets paper in a motion that turns many hinges at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/paper/folded_state.h"
#include "core/sweep/sweep.h"

namespace kiri {

/// Poses of all facets at a part of a motion, 0 to 1, continuous; no facet stretches.
using PosesAt = std::function<std::vector<Rigid>(double part)>;

/// What the motion meets. The members beside `verdict` tell of the first meeting; they are set
/// unless the verdict is Free.
struct PathReport {
  SweepVerdict verdict = SweepVerdict::Free;
  double part = 0;  ///< when the facets meet
  FacetId first;
  FacetId second;
  Vec3 place;  ///< model frame, mm
};

/// What facets meet each other between the start and the end of a motion that has no single axis.
/// `posesAt(0)` are the poses of `start`, whose layer order says who may leave which way; how
/// facets land at the end is for whoever orders them there. `moments`: parts from 0 to the end,
/// rising, between which nothing turns by more than a few degrees. Between two moments facets are
/// free of each other when they are farther apart than they can come: a point is taken not to stray
/// beyond 5/4 of its way from one moment to the next, measured in the frame of the other facet;
/// else moments between are looked at. Facets that share a hinge never meet (a fold angle stays
/// within 180 degrees); those that share a vertex are looked at away from it, for what passes
/// through near a common vertex does so at every distance. Undecided: a touch that rounding
/// decides, or facets that stay too near each other to tell, or stopped by `progress`.
PathReport checkPath(const FoldedState& start, const PosesAt& posesAt,
                     const std::vector<double>& moments, const Progress& progress = {});

}  // namespace kiri
