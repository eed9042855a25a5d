// What botanists measure on a leaf: size, shape, lobes and sinuses, symmetry.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/leaf/margin_points.h"
#include "core/leaf/oiv_measures.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// Measures of the outer contour of the paper, in the paper frame. mm, mm^2, degrees.
/// Conventions: Manual of Leaf Architecture (1999) for the angles of apex and base; ImageJ for
/// circularity, solidity, roundness and the ellipse; Royer et al. (2005) for lobes and teeth;
/// Palmer and Strobeck (1986) for fluctuating asymmetry.
struct LeafMeasures {
  Vec2 petiole;                ///< where the blade begins: what radii are measured from
  Vec2 axis;                   ///< unit direction from the petiole to the apex
  double length = 0;           ///< petiole to apex
  double fullLength = 0;       ///< extent along the axis: what lies below the petiole counts too
  double width = 0;            ///< extent across the axis
  double area = 0;             ///< of the paper, without holes
  double perimeter = 0;        ///< of the outer contour
  double aspectRatio = 0;      ///< length / width
  double fullAspectRatio = 0;  ///< fullLength / width
  double major = 0;            ///< axis of the ellipse of the same area and second moments
  double minor = 0;
  double feret = 0;           ///< greatest distance of two points
  double circularity = 0;     ///< 4 pi area / perimeter^2
  double roundness = 0;       ///< 4 area / (pi major^2)
  double solidity = 0;        ///< area / area of the convex hull
  double perimeterRatio = 0;  ///< perimeter / perimeter of the convex hull
  /// At the apex (the base) between the points where a line across the axis at 3/4 (1/4) of the
  /// length first meets the margin on either side; none where it does not on both.
  std::optional<double> apexAngle;
  std::optional<double> baseAngle;
  /// The greatest distance between the contour and its mirror image in the axis, mm.
  double asymmetry = 0;
  double leftArea = 0;  ///< of the axis, seen from the petiole to the apex
  double rightArea = 0;
  double leftWidth = 0;  ///< extent from the axis
  double rightWidth = 0;
  double areaAsymmetry = 0;         ///< |right - left| / mean of both
  double widthAsymmetry = 0;        ///< the same of the widths
  std::vector<MarginPoint> margin;  ///< tips and sinuses by turns, from the left of the base
                                    ///< clockwise
  int lobeCount = 0;                ///< all tips, teeth too
  int sinusCount = 0;
  int royerLobeCount = 0;  ///< tips that are lobes by the rule of Royer et al.; 0: unlobed
  int royerToothCount = 0;
  std::vector<OivMeasure> oiv;  ///< of leaves with creased veins
};

struct MeasureOptions {
  /// Paper frame; none: that of petioleOfVeins, or where there is none, the middle of the area.
  std::optional<Vec2> petiole;
  /// Degrees from +y, clockwise, and the apex is the tip nearest to it; none: towards the point of
  /// the contour that is farthest from the petiole.
  std::optional<double> axis;
  /// A tip counts when it stands out from the sinuses beside it by this part of the longest radius.
  double prominence = 0.02;
};

/// The end of most creases on the contour; none where no two meet, or as many elsewhere.
std::optional<Vec2> petioleOfVeins(const CreasePattern& pattern);

/// Measures the paper of a pattern, curves taken exactly but for distances, which are sampled and
/// refined. Errors: BadValue - more than one piece of paper; options out of range.
Result<LeafMeasures> measuresOf(const CreasePattern& pattern, const MeasureOptions& options = {});

}  // namespace kiri
