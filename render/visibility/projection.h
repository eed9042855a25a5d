// Borders of facets as they appear in a view.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/cubic.h"
#include "core/geometry/rigid.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// An arc of the view and the part of an arc on the paper that it shows.
struct SeenArc {
  Arc arc;               ///< view coordinates
  double from = 0;       ///< parameter on the paper at the start
  double to = 1;         ///< and at the end
  double nearStart = 1;  ///< enlargement at the start
  double nearEnd = 1;    ///< and at the end

  /// The parameter on the paper of the point at `t`.
  double onPaper(double t) const;
};

/// Adds the arcs that show `onPaper`, a part of a facet that lies as `pose` says. One arc, exact,
/// for straight arcs and in orthographic views. A cubic in perspective is rational: it becomes as
/// many cubics as keep every point within `tolerance` (mm in the view) of its place. An arc run
/// backwards is divided at the same places.
void appendSeen(const Arc& onPaper, const Rigid& pose, const ViewFrame& view, double tolerance,
                std::vector<SeenArc>& out);

}  // namespace kiri
