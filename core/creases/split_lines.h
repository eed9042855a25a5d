// Lines are divided where they cross and where vertices lie on them.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/line_map.h"
#include "core/creases/repair_log.h"

namespace kiri {

/// Divides until lines meet at their ends only, or lie on each other from end to end. A loose end
/// beside a line is drawn to it along its own line; a line bends through other vertices beside it.
/// Pieces of a line stand where the line stood, in its direction. Errors: those of meetingsOf;
/// BadFile - lines so tangled that dividing makes new crossings without end, with the place.
Status splitLines(LineMap& map, const RepairScale& scale, RepairLog& log,
                  const Progress& progress = {});

}  // namespace kiri
