// The lines in which facets of different planes pass through each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "render/visibility/facet_view.h"

namespace kiri {

/// A segment of the view along which two facets are equally near: on one side of it one of them is
/// in front, on the other side the other. Paper does this only where a collision was accepted.
struct PassingLine {
  Vec2 from;
  Vec2 to;
};

std::vector<PassingLine> passingLines(const FacetViews& views,
                                      const std::vector<std::uint32_t>& inSight);

}  // namespace kiri
