// Ends of lines that are meant to be one vertex become one.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/creases/line_map.h"
#include "core/creases/repair_log.h"

namespace kiri {

/// The lines of a drawing that have a length and numbers of a possible size for coordinates; the
/// others are told.
std::vector<DrawnCrease> soundLines(const CreaseDrawing& drawing, RepairLog& log);

/// Every end joins the nearest vertex within the distance, or becomes a vertex: vertices do not
/// grow into chains, so two of them are farther apart than the distance before each moves to the
/// middle of its ends. Ends at one place stay there bit by bit. Vertices are numbered by their
/// first appearance. Lines whose ends become one vertex are told and left out.
LineMap weld(const std::vector<DrawnCrease>& lines, const RepairScale& scale, RepairLog& log);

/// Makes points that have come within `same` of each other one, the first of them. Returns whether
/// there were any.
bool mergeSamePoints(LineMap& map, double same);

}  // namespace kiri
