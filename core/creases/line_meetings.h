// Where lines cross, and where vertices lie on lines.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/line_map.h"

namespace kiri {

/// A point at most `within` beside the inside of a line that does not end there.
struct LineTouch {
  std::uint32_t line = 0;
  std::uint32_t point = 0;
  double along = 0;  ///< 0 at the start of the line, 1 at its end
};

/// Two lines, the first with the lower number, that have each other's ends on both sides.
struct LineCrossing {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  Vec2 place;
};

struct LineMeetings {
  std::vector<LineTouch> touches;       ///< by line, then along it
  std::vector<LineCrossing> crossings;  ///< by the lines
};

/// All meetings. Sides are exact for the stored doubles. Cost: n log n and what crosses. Errors:
/// BadFile - more meetings than any pattern has; Cancelled.
Result<LineMeetings> meetingsOf(const LineMap& map, double within, const Progress& progress = {});

/// Calls `see` for each used point and each line that does not end there but lies at most
/// `farthest` away from it, in a fixed order. False when there would be too many such pairs: then
/// some were seen. Errors: Cancelled.
Result<bool> visitNearPairs(const LineMap& map, double farthest,
                            const std::function<void(std::uint32_t point, double distance)>& see,
                            const Progress& progress = {});

}  // namespace kiri
