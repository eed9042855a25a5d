// From lines and faces to the pattern that the kernel reads.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/creases/assigned_pattern.h"
#include "core/creases/map_faces.h"
#include "core/creases/repair_log.h"

namespace kiri {

/// A facet for each face that is paper. Lines without paper are left out, lines with paper on one
/// side become borders, borders with paper on both sides cuts; all told. No crease has the same
/// face on both sides. Places and lengths are multiplied by `scale`.
AssignedPattern buildPattern(const LineMap& map, const MapFaces& faces,
                             const std::vector<bool>& isPaper, double scale, RepairLog& log);

}  // namespace kiri
