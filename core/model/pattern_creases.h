// Drawing the creases of a PatternStep on the sheet.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/model/step.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// The sheet divided along the creases of a pattern. Crease i of the step is edge `firstCrease` +
/// i, in its own direction; cuts are edges of kind Cut, all others hinges at angle 0.
struct CreasedSheet {
  CreasePattern pattern;
  std::size_t firstCrease = 0;
};

/// Coordinates stay as they are, to the last bit; a vertex within tolerance.length() of a corner of
/// the sheet is that corner. Errors: BadValue - `sheet` has more than one facet, a position that is
/// no vertex, two vertices in one place, creases that cross, touch or repeat each other or leave
/// the sheet; WouldStretch - a crease that ends inside a facet, where it cannot fold; TooThin - a
/// sliver of paper. Each with the place. Cost: n log n for n creases that are short beside the
/// sheet.
Result<CreasedSheet> creasedSheet(const CreasePattern& sheet, const PatternStep& step);

}  // namespace kiri
