// SPDX-License-Identifier: MIT
#include "core/creases/assigned_pattern.h"

#include <algorithm>
#include <cmath>

namespace kiri {

bool isMeantFlat(const AssignedPattern& creases) {
  return std::all_of(creases.pattern.edges.begin(), creases.pattern.edges.end(), [](const Edge& e) {
    return e.kind != EdgeKind::Hinge || e.angle == 0 || std::abs(e.angle) == 180;
  });
}

}  // namespace kiri
