// Closed loops of creases: the ways over hinges that come back to the facet they start from.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/rigid.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// One fold angle for each edge of a pattern, degrees, valley positive; 0 where there is no hinge.
using FoldAngles = std::vector<double>;

/// A hinge as a loop crosses it: the pose of the facet behind is the pose of the facet before,
/// composed with the rotation about the hinge by `sign` times its fold angle.
struct Crossing {
  EdgeId hinge;
  double sign = 1;
  Vec2 point;      ///< on the hinge, relative to the loop's centre, mm
  Vec2 direction;  ///< unit, along the hinge
};

/// The rotations of a loop, composed in order, must come out as the identity: that is the condition
/// that it puts on the fold angles.
struct HingeLoop {
  std::vector<Crossing> crossings;
  Vec2 centre;            ///< paper frame
  bool isVertex = false;  ///< all hinges pass through the centre: only turns count, no shifts
};

/// Loops that generate all others: one around each vertex inside the paper, one around each hole,
/// slit and tear inside the paper. A crease pattern whose hinges form no closed loop has none.
/// Source: guide to algorithms 1.8 and 7.1.
std::vector<HingeLoop> loopsOf(const CreasePattern& pattern);

/// The rotation that one crossing makes, and what all crossings of a loop make together, with the
/// loop's centre as origin: the identity when it closes.
Rigid turnOf(const Crossing& crossing, const FoldAngles& angles);
Rigid turnOf(const HingeLoop& loop, const FoldAngles& angles);

}  // namespace kiri
