// Lines on each other become one; pieces of a line that nothing parts become one again.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/creases/line_map.h"
#include "core/creases/repair_log.h"

namespace kiri {

/// Of lines between the same two vertices one is kept: border before cut, mountain and valley,
/// unassigned, flat, join; of equals the first. It stands where the first of them stood.
void dropOverlaps(LineMap& map, RepairLog& log);

/// Makes one line again of pieces of a drawn line that meet at one of the `parted` points (by
/// point), where no other line ends any more. The line stands where its first piece stood. Returns
/// whether there were any.
bool joinPieces(LineMap& map, const std::vector<bool>& parted, RepairLog& log);

}  // namespace kiri
