// When two convex patches first meet while one of them turns.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/sweep/facet_body.h"

namespace kiri {

/// A meeting: after which turn, and where (axis frame).
struct Meeting3 {
  Turn turn;
  Vec3 place;
};

/// How near is meeting, and how far from its ends a motion counts.
struct MeetingSlack {
  double reach = 0;  ///< mm: a point this far outside a patch still meets it
  double ends = 0;   ///< mm: what meets before (after) its place has moved this far is at the end
};

/// The first meeting of two patches strictly inside the motion: corner against patch (both ways)
/// and side against side, in closed form; source: guide to algorithms 2.4. Patches that pass
/// through each other all the way without a corner or side meeting anything meet at no turn.
/// `known`: whether they lie in one plane at an end.
std::optional<Meeting3> firstMeeting(const Patch& moving, const Patch& resting,
                                     const AxisFrame& frame, KnownRoots known, MeetingSlack slack);

}  // namespace kiri
