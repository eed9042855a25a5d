// Makes all sides of one face of the planar map agree about what is seen in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "render/visibility/arrangement.h"
#include "render/visibility/coverage.h"

namespace kiri {

/// Where many facets of different planes meet in a point, sides hardly longer than the tolerance
/// may contradict each other, for all depths there are equal; the borders of what is seen would not
/// close. Then, and only then, each face of the map is gone round, and what most of its border says
/// (by length) holds for all of it.
void settleFaces(const Arrangement& map, std::vector<SeenBeside>& seen);

}  // namespace kiri
