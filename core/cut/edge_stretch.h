// The part of an edge that lies along a segment.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/paper/crease_pattern.h"

namespace kiri {

/// The part of a straight edge, as parameters in its own direction, that lies along one segment.
struct Stretch {
  EdgeId edge;
  double t0 = 0;
  double t1 = 1;
  double from = 0;  ///< along the segment, mm
  double to = 0;
};

/// The two ends of an edge, in the frame of the segment.
struct EdgeEnds {
  Vec3 from;
  Vec3 to;
};

/// The part of the edge that lies along the segment from `p` to `q`, within tolerance.match(); none
/// when they share no length.
std::optional<Stretch> stretchAlong(EdgeId edge, const EdgeEnds& ends, Vec3 p, Vec3 q,
                                    const Tolerance& tolerance);

/// The edge that is just the stretch: divides the edge where the stretch starts or ends between its
/// ends.
EdgeId isolate(CreasePattern& pattern, const Stretch& stretch);

}  // namespace kiri
