// The one curve that cuts the folded leaf.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/cubic.h"
#include "core/leaf/folded_half.h"

namespace kiri {

/// A tip, a sinus or another place that the margin passes, in the folded leaf, seen from the
/// petiole with the innermost sector at rest: degrees clockwise from the mid-vein there, and the
/// distance as part of the mid-vein's length.
struct MarginKnot {
  std::string name;
  double folded = 0;
  double length = 0;
};

/// "the second vein (folded it lies at 6 degrees, 0.88 from the petiole)".
std::string told(const MarginKnot& knot);

/// Where the ends of all creases lie in the folded leaf, in their order, and then the further
/// places of the margin. Errors: BadValue - two that no single margin curve can cut, with the
/// remedy: along it lengths must fall as the rays' folded directions turn away from the mid-vein.
Result<std::vector<MarginKnot>> marginKnots(const LeafRecipe& recipe, const FoldedHalf& half);

/// The margin in the folded leaf: a clamped uniform cubic B-spline, in units of the mid-vein's
/// length; the petiole is the origin, the mid-vein of the innermost sector points along +y.
struct MarginCurve {
  std::vector<Vec2> controls;
  std::vector<Arc> arcs;               ///< its pieces
  std::vector<std::size_t> crossings;  ///< by knot: the piece that starts there
};

/// The curve through the knots, nearer and nearer to the petiole, smooth between them, and a little
/// beyond the paper at either end. Errors: BadValue - knots between which no curve can pass so that
/// it crosses each crease once and the leaf has its lobes and sinuses where the creases end.
Result<MarginCurve> marginCurve(const FoldedHalf& half, const std::vector<MarginKnot>& knots);

/// The margin of the facet between creases i and i + 1 on the flat half: places from the end of its
/// vein to that of its anti-vein (or basal edge), `perPiece` for each piece of the curve.
std::vector<Vec2> marginOfFacet(const FoldedHalf& half, const MarginCurve& curve, std::size_t facet,
                                int perPiece);

/// What marginCurve checks. Errors: as there.
Status checkMargin(const FoldedHalf& half, const std::vector<MarginKnot>& knots,
                   const MarginCurve& curve);

}  // namespace kiri
