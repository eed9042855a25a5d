// The box of a facet on the sheet.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/bounds.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// A box, in the paper frame, that holds the facet: that of the control points of its border.
Box boundsOf(const CreasePattern& pattern, const Facet& facet);

}  // namespace kiri
