// What botanists measure on a leaf: size, shape, lobes and sinuses, symmetry.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// A lobe tip or a sinus: where the margin is farthest from the petiole, or nearest to it.
struct MarginPoint {
  bool isLobe = true;
  Vec2 place;         ///< paper frame, mm
  double angle = 0;   ///< degrees from the axis, clockwise positive (right half), -180 to 180
  double length = 0;  ///< mm from the petiole
};

/// Measures of the outer contour of the paper, in the paper frame. mm, mm^2, degrees.
/// Conventions: Manual of Leaf Architecture (1999); ImageJ for circularity and solidity.
struct LeafMeasures {
  Vec2 petiole;               ///< where the blade begins: what radii are measured from
  Vec2 axis;                  ///< unit direction from the petiole to the apex
  double length = 0;          ///< petiole to apex
  double fullLength = 0;      ///< extent along the axis: what lies below the petiole counts too
  double width = 0;           ///< extent across the axis
  double area = 0;            ///< of the paper, without holes
  double perimeter = 0;       ///< of the outer contour
  double aspectRatio = 0;     ///< length / width
  double circularity = 0;     ///< 4 pi area / perimeter^2
  double solidity = 0;        ///< area / area of the convex hull
  double perimeterRatio = 0;  ///< perimeter / perimeter of the convex hull
  /// The greatest distance between the contour and its mirror image in the axis, mm.
  double asymmetry = 0;
  double leftArea = 0;  ///< of the axis, seen from the petiole to the apex
  double rightArea = 0;
  std::vector<MarginPoint>
      margin;  ///< lobes and sinuses by turns, counter-clockwise from the axis's back
  int lobeCount = 0;
  int sinusCount = 0;
};

struct MeasureOptions {
  /// Paper frame; none: the end of most hinges on the contour, or where there are no hinges, the
  /// middle of the area.
  std::optional<Vec2> petiole;
  /// Degrees from +y, clockwise; none: towards the point of the contour that is farthest from the
  /// petiole.
  std::optional<double> axis;
  /// A lobe counts when it stands out from the sinuses beside it by this part of the longest
  /// radius.
  double prominence = 0.02;
};

/// Measures the paper of a pattern, curves taken exactly but for distances, which are sampled and
/// refined. Errors: BadValue - more than one piece of paper; options out of range.
Result<LeafMeasures> measuresOf(const CreasePattern& pattern, const MeasureOptions& options = {});

}  // namespace kiri
