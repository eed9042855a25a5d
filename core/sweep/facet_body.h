// A facet as the sweep sees it: its plane, what it can reach, and its inside as convex polygons.
// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "core/paper/folded_state.h"
#include "core/sweep/turn.h"

namespace kiri {

/// Points of a plane of the axis frame, convex, counter-clockwise about `normal`.
struct Patch {
  std::vector<Vec3> points;
  Vec3 normal;
  double offset = 0;  ///< dot(normal, p) of its points
  double zLow = 0;
  double zHigh = 0;
  double rHigh = 0;
  bool goesOn = false;  ///< across one of its sides the paper goes straight on

  double heightOf(Vec3 p) const { return dot(normal, p) - offset; }
  /// Whether a point of the plane lies inside or within `slack` of it.
  bool covers(Vec3 p, double slack) const;
};

/// Where a side of one patch runs through another, or within `reach` of it.
std::optional<Vec3> piercing(const Patch& a, const Patch& b, double reach);

/// How a facet lies to the axis.
enum class Stance {
  Page,     ///< the axis lies in its plane: it turns like the page of a book
  Level,    ///< its plane is across the axis: it turns within its plane
  Slanting  ///< anything else
};

/// Where a facet is, in the frame of the axis before the motion.
struct Body {
  FacetId facet;
  Stance stance = Stance::Slanting;
  Vec3 normal;
  double offset = 0;
  std::vector<Vec3> hull;  ///< corners of the border and controls of its curves
  double zLow = 0;
  double zHigh = 0;
  double rLow = 0;
  double rHigh = 0;
  double from = 0;      ///< azimuth, radians, roughly: see kAzimuthSlack
  double width = 0;     ///< azimuths from `from` on; kFullTurn when all
  bool goesOn = false;  ///< across one of its sides the paper goes straight on
};

inline constexpr double kFullTurn = 2 * std::numbers::pi;
/// Azimuths of a Body are no further off than this.
inline constexpr double kAzimuthSlack = 0.02;

Body bodyOf(const FoldedState& state, const std::vector<bool>& moves, const AxisFrame& frame,
            FacetId facet);

/// The inside of a facet, taken in from its border by `margin`, as patches. Where the paper goes on
/// straight (flat hinges to facets that move alike) nothing is taken in but at the corners.
/// What is left is all that lies deeper than about twice the margin, and nothing less deep
/// than half of it.
std::vector<Patch> insideOf(const FoldedState& state, const std::vector<bool>& moves,
                            const AxisFrame& frame, FacetId facet, double margin);

}  // namespace kiri
